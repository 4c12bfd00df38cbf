/** Which keyposes get a card in the strip, and where the cards stand: pure geometry. */

export interface Card {
  /** Index of the keypose in time order. */
  readonly keypose: number;
  /** Middle of the card, pixels right of the gutter. */
  readonly x: number;
}

export interface StripLayout {
  readonly cards: readonly Card[];
  readonly cardWidth: number;
}

export interface StripRoom {
  /** The keyposes that may be shown: from `first` up to, not including, `end`. */
  readonly first: number;
  readonly end: number;
  /** One of them that must be shown, whatever its intensity; null: none. */
  readonly kept: number | null;
  /** The width of the strip in pixels. */
  readonly width: number;
  /** The least width of a card in pixels: 48, or what its text needs. */
  readonly leastCard: number;
}

export const SMALLEST_CARD = 48;
const WIDEST_CARD = 63;
const MARGIN = 2;
/** Widths in a card's line of text, in pixels: a digit, a decimal point, the gap after the number. */
const DIGIT = 6.9;
const POINT = 3.5;
const LABEL_GAP = 5;
const LABEL_MARGIN = 4;
const MOST_DIGITS = 2;
/** Pixels of one body height where the figures are neither taller nor wider than their room. */
const USUAL_SCALE = 55;
/** The figures' room upward in pixels, and across in widths of a card: arms may reach over a little. */
const ROOM_UP = 62;
const ROOM_ACROSS = 1.15;

/**
 * Lays out cards near their pins. If not all fit, the most intense that fit are shown, in time
 * order.
 * @param pinX pixel of each keypose's pin, ascending
 * @param intensities intensity of each keypose
 */
export function layoutStrip(
  pinX: ArrayLike<number>,
  intensities: ArrayLike<number>,
  { first, end, kept, width, leastCard }: StripRoom,
): StripLayout {
  const room = Math.max(0, Math.floor((width - 2 * MARGIN) / leastCard));
  const visible = Array.from({ length: Math.max(0, end - first) }, (_, index) => first + index);
  const shown = mostIntense(visible, intensities, room, kept);
  if (shown.length === 0) return { cards: [], cardWidth: leastCard };
  const widest = Math.max(WIDEST_CARD, leastCard);
  const cardWidth = Math.min(widest, Math.floor((width - 2 * MARGIN) / shown.length));
  const low = cardWidth / 2 + MARGIN;
  const xs = spread(
    shown.map((keypose) => pinX[keypose]),
    cardWidth,
    low,
    width - low,
  );
  return { cards: shown.map((keypose, index) => ({ keypose, x: xs[index] })), cardWidth };
}

/** Width of a card's line of text with whole seconds, margins included. */
export function leastLabelWidth(number: number, timeS: number): number {
  const digits = String(number).length + String(Math.floor(timeS)).length;
  return Math.ceil(LABEL_MARGIN + LABEL_GAP + digits * DIGIT);
}

/** Decimals of the seconds beside a keypose's number: at most 2, as many as a card has room for. */
export function labelDigits(number: number, timeS: number, cardWidth: number): number {
  const room = cardWidth - leastLabelWidth(number, timeS) - POINT;
  return Math.max(0, Math.min(MOST_DIGITS, Math.floor(room / DIGIT)));
}

/** Pixels of one body height, the same for all figures of a strip, so that a leap is seen as one. */
export function stripScale(
  figures: readonly { readonly minX: number; readonly maxX: number; readonly maxY: number }[],
  cardWidth: number,
): number {
  return figures.reduce((scale, { minX, maxX, maxY }) => {
    const up = maxY > 0 ? ROOM_UP / maxY : scale;
    const across = maxX > minX ? (ROOM_ACROSS * cardWidth) / (maxX - minX) : scale;
    return Math.min(scale, up, across);
  }, USUAL_SCALE);
}

function mostIntense(
  keyposes: readonly number[],
  intensities: ArrayLike<number>,
  count: number,
  kept: number | null,
): number[] {
  if (keyposes.length <= count) return [...keyposes];
  const rank = (keypose: number): number => (keypose === kept ? Infinity : intensities[keypose]);
  return [...keyposes]
    .sort((a, b) => rank(b) - rank(a) || a - b)
    .slice(0, count)
    .sort((a, b) => a - b);
}

/**
 * The places nearest to `wanted` (ascending) that keep a distance of `gap`, in order, within
 * [low, high]: isotonic regression by pooling of neighbours that would overlap.
 */
export function spread(
  wanted: readonly number[],
  gap: number,
  low: number,
  high: number,
): number[] {
  const pools: { sum: number; count: number }[] = [];
  wanted.forEach((x, index) => {
    pools.push({ sum: x - index * gap, count: 1 });
    mergeDescending(pools);
  });
  const last = high - (wanted.length - 1) * gap;
  const starts = pools.flatMap(({ sum, count }) => new Array<number>(count).fill(sum / count));
  return starts.map((start, index) => Math.max(low, Math.min(last, start)) + index * gap);
}

function mergeDescending(pools: { sum: number; count: number }[]): void {
  while (pools.length > 1) {
    const [before, after] = [pools.at(-2)!, pools.at(-1)!];
    if (before.sum / before.count <= after.sum / after.count) return;
    pools.pop();
    before.sum += after.sum;
    before.count += after.count;
  }
}
