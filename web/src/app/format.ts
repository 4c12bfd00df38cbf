/**
 * Numbers in; text by the rules of a language out. Digits are fixed where figures stand under each
 * other or move, so that they do not jump.
 */
export interface Format {
  readonly integer: (value: number) => string;
  readonly decimal: (value: number, digits: number) => string;
  /** Up to `digits` digits after the point, none that say nothing: 120, 59.94. */
  readonly short: (value: number, digits: number) => string;
  /** A place in an order: 11th; the bare number where the language's sentence has its own word. */
  readonly ordinal: (value: number) => string;
  /** The length of a clip: 6.0, or 12:05 from two minutes on (then without a unit). */
  readonly duration: (seconds: number) => { readonly text: string; readonly inSeconds: boolean };
  readonly bytes: (count: number) => string;
  /** How a p-value is told: "= 0.012", "< 10⁻¹⁶". */
  readonly probability: (p: number) => string;
}

const superscripts: Readonly<Record<string, string>> = {
  '-': '⁻',
  '0': '⁰',
  '1': '¹',
  '2': '²',
  '3': '³',
  '4': '⁴',
  '5': '⁵',
  '6': '⁶',
  '7': '⁷',
  '8': '⁸',
  '9': '⁹',
};

const ordinalEndings: Readonly<Record<string, Readonly<Record<string, string>>>> = {
  en: { one: 'st', two: 'nd', few: 'rd', other: 'th' },
};

function ordinalEnding(language: string, value: number): string {
  const form = new Intl.PluralRules(language, { type: 'ordinal' }).select(value);
  return ordinalEndings[language]?.[form] ?? '';
}

const superscript = (value: number): string =>
  [...String(value)].map((sign) => superscripts[sign] ?? sign).join('');

/** 10⁻⁷ */
export const powerOfTen = (exponent: number): string => `10${superscript(exponent)}`;

const smallestExponent = -300;

function clockText(seconds: number): string {
  const whole = Math.round(seconds);
  const pad = (value: number): string => String(value).padStart(2, '0');
  const minutes = Math.floor(whole / 60);
  const rest = pad(whole % 60);
  return minutes < 60
    ? `${minutes}:${rest}`
    : `${Math.floor(minutes / 60)}:${pad(minutes % 60)}:${rest}`;
}

/** The least power of ten that is not below a probability. */
const exponentAbove = (p: number): number =>
  p > 0 ? Math.max(smallestExponent, Math.ceil(Math.log10(p))) : smallestExponent;

export function createFormat(language: string): Format {
  const formats = new Map<string, Intl.NumberFormat>();
  const number = (value: number, options: Intl.NumberFormatOptions): string => {
    const key = JSON.stringify(options);
    const format = formats.get(key) ?? new Intl.NumberFormat(language, options);
    formats.set(key, format);
    return format.format(value);
  };
  const decimal = (value: number, digits: number): string =>
    number(value, { minimumFractionDigits: digits, maximumFractionDigits: digits });

  return {
    integer: (value) => number(value, { maximumFractionDigits: 0 }),
    ordinal: (value) => number(value, {}) + ordinalEnding(language, value),
    decimal,
    short: (value, digits) => number(value, { maximumFractionDigits: digits }),
    duration: (seconds) =>
      seconds < 120
        ? { text: decimal(seconds, 1), inSeconds: true }
        : { text: clockText(seconds), inSeconds: false },
    bytes: (count) => {
      const [value, unit] =
        count < 1e6
          ? [count / 1e3, 'kilobyte']
          : count < 1e9
            ? [count / 1e6, 'megabyte']
            : [count / 1e9, 'gigabyte'];
      return number(value, {
        style: 'unit',
        unit,
        unitDisplay: 'short',
        maximumFractionDigits: value < 100 ? 1 : 0,
      });
    },
    probability: (p) => (p >= 0.001 ? `= ${decimal(p, 3)}` : `< ${powerOfTen(exponentAbove(p))}`),
  };
}
