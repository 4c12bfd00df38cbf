/** The tokens of the theme in; the colours that matrix, tree and map are drawn in out. */

export interface ComparePalette {
  readonly ink: string;
  readonly text2: string;
  readonly text3: string;
  readonly panel: string;
  readonly raised: string;
  readonly line2: string;
  readonly line3: string;
  readonly kp: string;
  readonly kpText: string;
  readonly kpSoft: string;
  readonly onKp: string;
  readonly left: string;
  readonly right: string;
  readonly trunk: string;
  readonly shade: string;
  /** Ink as `r g b`. */
  readonly inkParts: string;
  readonly labels: readonly string[];
  /** Alike to different. */
  readonly distances: readonly string[];
}

const range = (count: number): number[] => [...Array(count).keys()];

/** As `#rrggbb`, however the style sheet has been shortened. */
function sixDigits(context: CanvasRenderingContext2D, colour: string): string {
  context.fillStyle = colour;
  return context.fillStyle;
}

export function comparePalette(element: Element): ComparePalette {
  const style = getComputedStyle(element);
  const plain = (name: string): string => style.getPropertyValue(`--${name}`).trim();
  const context = document.createElement('canvas').getContext('2d');
  const token = (name: string): string => (context ? sixDigits(context, plain(name)) : plain(name));
  return {
    ink: token('t-1'),
    text2: token('t-2'),
    text3: token('t-3'),
    panel: token('panel'),
    raised: token('raised'),
    line2: token('line2'),
    line3: token('line3'),
    kp: token('kp'),
    kpText: token('kp-text'),
    kpSoft: token('kp-soft'),
    onKp: token('on-kp'),
    left: token('left'),
    right: token('right'),
    trunk: token('trunk'),
    shade: token('shade'),
    inkParts: plain('ink'),
    labels: range(6).map((k) => token(`label-${k}`)),
    distances: range(9).map((k) => token(`distance-${k}`)),
  };
}

/** The colour of a label; −1: of clips without one, and of branches with several. */
export const labelColour = (palette: ComparePalette, label: number): string =>
  label < 0 ? palette.text3 : palette.labels[label % palette.labels.length];
