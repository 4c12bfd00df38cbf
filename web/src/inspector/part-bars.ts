/** How fast the parts of the body are here, against their surroundings: ascending rows and the extents of bars. */
import type { BodyPart } from '../engine/types';

/** In the order of the columns of `bodyPartPercents`. */
const parts: readonly BodyPart[] = ['left-arm', 'right-arm', 'left-leg', 'right-leg', 'head'];

export interface PartBar {
  readonly part: BodyPart;
  readonly side: 'left' | 'right' | 'trunk';
  /** null: no speed to compare with. */
  readonly percent: number | null;
}

const sideOf = (part: BodyPart): PartBar['side'] =>
  part.startsWith('left') ? 'left' : part.startsWith('right') ? 'right' : 'trunk';

/** The rows of one keypose, ascending, those without a value last; none where the body is not human. */
export function partBars(percents: ArrayLike<number>, keypose: number): readonly PartBar[] {
  const first = keypose * parts.length;
  if (percents.length < first + parts.length) return [];
  const rows = parts.map((part, index): PartBar => {
    const value = percents[first + index] ?? NaN;
    return { part, side: sideOf(part), percent: Number.isNaN(value) ? null : value };
  });
  return rows.sort((a, b) => (a.percent ?? Infinity) - (b.percent ?? Infinity) || 0);
}

export const barWidth = 150;
export const barHeight = 10;
const middle = barWidth / 2;
const fullPx = 64;
const fullPercent = 100;
const top = 1.5;
const bottom = 8.5;
const tipPx = 5;

/** SVG path data of a bar from the zero line; one that is longer than there is room for ends in a point. */
export function barPath(percent: number): string {
  const share = percent / fullPercent;
  if (Math.abs(share) <= 1) {
    const end = middle + share * fullPx;
    return `M${middle} ${top}H${end}V${bottom}H${middle}Z`;
  }
  const direction = Math.sign(share);
  const shoulder = middle + direction * (fullPx + 2);
  return `M${middle} ${top}H${shoulder}l${direction * tipPx} ${(bottom - top) / 2}L${shoulder} ${bottom}H${middle}Z`;
}
