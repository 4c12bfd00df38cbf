// Numbers as an English page writes them. In: values. Out: text.

export const decimal = (value: number, digits: number): string =>
  value.toLocaleString('en', { minimumFractionDigits: digits, maximumFractionDigits: digits });

/** No digits that say nothing. */
export const short = (value: number, digits: number): string =>
  value.toLocaleString('en', { maximumFractionDigits: digits });

/** Speeds and intensities beside the timeline. */
export const figure = (value: number): string => decimal(value, value < 10 ? 1 : 0);

/** Lengths in the unit of the file. */
export const length = (value: number): string => {
  const size = Math.abs(value);
  return decimal(value, size >= 100 ? 1 : size >= 10 ? 2 : 3);
};

const superscripts = '⁰¹²³⁴⁵⁶⁷⁸⁹';

export function probability(p: number): string {
  if (p >= 0.001) return `= ${decimal(p, 3)}`;
  const exponent = String(-Math.max(-300, Math.ceil(Math.log10(p))));
  return `< 10⁻${exponent.replace(/\d/g, (digit) => superscripts[Number(digit)] ?? '')}`;
}

export function signedPercent(value: number | null): string {
  if (value === null) return '–';
  const whole = Math.round(value);
  return `${whole < 0 ? '−' : whole > 0 ? '+' : ''}${Math.abs(whole)} %`;
}

export const plural = (count: number, one: string): string =>
  `${count} ${one}${count === 1 ? '' : 's'}`;
