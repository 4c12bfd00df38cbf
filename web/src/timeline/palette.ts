/** The tokens of the theme in; the colours that the rows are drawn in out. */
export interface Palette {
  readonly ink: string;
  readonly text3: string;
  readonly panel: string;
  readonly raised: string;
  readonly line1: string;
  readonly line2: string;
  readonly kp: string;
  readonly kpLine: string;
}

const tokens: Readonly<Record<keyof Palette, string>> = {
  ink: '--t-1',
  text3: '--t-3',
  panel: '--panel',
  raised: '--raised',
  line1: '--line1',
  line2: '--line2',
  kp: '--kp',
  kpLine: '--kp-line',
};

export function paletteOf(element: Element): Palette {
  const style = getComputedStyle(element);
  const colours = Object.entries(tokens).map(
    ([name, token]) => [name, style.getPropertyValue(token).trim()] as const,
  );
  return Object.fromEntries(colours) as unknown as Palette;
}
