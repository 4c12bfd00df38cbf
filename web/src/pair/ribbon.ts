/** The alignment of two clips and their axes in; the lines between matching moments out: pure geometry. */
import type { Axis } from '../timeline/axis';
import type { Alignment, ClipLength } from './alignment';
import { rows } from './rows-layout';

export interface RibbonClip extends ClipLength {
  readonly axis: Axis;
}

/** Pixels between lines, as the pair's own time passes. */
const APART = 16;
const MOST_LINES = 400;
/** How far the curve leaves either side upright. */
const BEND = 32;

/** SVG path data of a line from a place of A to a place of B. */
export function bend(xA: number, xB: number, inset = 0): string {
  const [top, bottom] = [rows.ribbon.top + inset, rows.ribbon.top + rows.ribbon.height - inset];
  return `M${px(xA)} ${top}C${px(xA)} ${top + BEND - inset} ${px(xB)} ${bottom - BEND + inset} ${px(xB)} ${bottom}`;
}

/** Lines at even steps of the pair's own time while both clips run. */
export function matchingLines(alignment: Alignment, a: RibbonClip, b: RibbonClip): string {
  const { fromS, toS } = alignment.common;
  const width = Math.max(a.axis.x(a.frames - 1), b.axis.x(b.frames - 1));
  const count = Math.max(1, Math.min(MOST_LINES, Math.round(width / APART)));
  let path = '';
  for (let line = 0; line <= count; line++) {
    const at = fromS + ((toS - fromS) * line) / count;
    path += bend(xOf(alignment.timeOf(0, at), a), xOf(alignment.timeOf(1, at), b), 7);
  }
  return path;
}

/** The lines of A's keyposes. */
export function keyposeLines(
  alignment: Alignment,
  keyposes: Int32Array,
  a: RibbonClip,
  b: RibbonClip,
): string {
  const { fromS, toS } = alignment.common;
  let path = '';
  for (const frame of keyposes) {
    const at = alignment.pairTimeOf(0, frame * a.frameTimeS);
    if (at < fromS || at > toS) continue;
    path += bend(a.axis.x(frame), xOf(alignment.timeOf(1, at), b));
  }
  return path;
}

function xOf(timeS: number, { axis, frameTimeS }: RibbonClip): number {
  return axis.x(timeS / frameTimeS);
}

const px = (value: number): string => String(Math.round(value * 10) / 10);
