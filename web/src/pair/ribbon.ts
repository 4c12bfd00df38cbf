/** The alignment of two clips and their axes in; the lines between matching moments out: pure geometry. */
import type { Axis } from '../timeline/axis';
import type { Alignment, ClipLength } from './alignment';
import { rows } from './rows-layout';

export interface RibbonClip extends ClipLength {
  readonly axis: Axis;
}

/** Pixels between lines, as the pair's own time passes. */
const APART = 16;
const MOST_LINES = 2000;
/** Lines nearer than this cannot be told apart, in pixels. */
const CLOSE = 6;
/** Room for the ticks. */
const LINE_INSET = 7;
/** How far the curve leaves either side upright. */
const BEND = 32;

/** SVG path data of a line from a place of A to a place of B. */
export function bend(xA: number, xB: number, inset = 0): string {
  const [top, bottom] = [rows.ribbon.top + inset, rows.ribbon.top + rows.ribbon.height - inset];
  return `M${px(xA)} ${top}C${px(xA)} ${top + BEND - inset} ${px(xB)} ${bottom - BEND + inset} ${px(xB)} ${bottom}`;
}

/** Lines at even steps of the pair's own time while both clips run, where A or B is in view. */
export function matchingLines(alignment: Alignment, a: RibbonClip, b: RibbonClip): string {
  const { fromS, toS } = timesInView(alignment, a, b);
  const stepS = Math.max((APART / a.axis.scale) * a.frameTimeS, (toS - fromS) / MOST_LINES);
  const origin = alignment.common.fromS;
  const lines = new Lines(a.axis.width, CLOSE, LINE_INSET);
  for (let line = Math.ceil((fromS - origin) / stepS - 1e-9); ; line++) {
    const at = origin + line * stepS;
    if (!(at <= toS + 1e-9)) return lines.path;
    lines.add(xOf(alignment.timeOf(0, at), a), xOf(alignment.timeOf(1, at), b));
  }
}

/** The pair's own time while both run and A or B is in view. */
function timesInView(alignment: Alignment, a: RibbonClip, b: RibbonClip) {
  const times = [a, b].flatMap(({ axis, frameTimeS }, clip) =>
    [0, axis.width].map((x) => alignment.pairTimeOf(clip, axis.placeAt(x) * frameTimeS)),
  );
  const { common } = alignment;
  return {
    fromS: Math.max(common.fromS, Math.min(...times)),
    toS: Math.min(common.toS, Math.max(...times)),
  };
}

/** The lines of A's keyposes that are in view; of many that stand close, some. */
export function keyposeLines(
  alignment: Alignment,
  keyposes: Int32Array,
  a: RibbonClip,
  b: RibbonClip,
): string {
  const { fromS, toS } = alignment.common;
  const lines = new Lines(a.axis.width, CLOSE);
  for (const frame of keyposes) {
    const at = alignment.pairTimeOf(0, frame * a.frameTimeS);
    if (at >= fromS && at <= toS) lines.add(a.axis.x(frame), xOf(alignment.timeOf(1, at), b));
  }
  return lines.path;
}

/** Lines from left to right: those out of view and those too close to the one before are left out. */
class Lines {
  path = '';
  private before = -Infinity;

  constructor(
    private readonly width: number,
    private readonly apart: number,
    private readonly inset = 0,
  ) {}

  add(xA: number, xB: number): void {
    if (Math.max(xA, xB) < 0 || Math.min(xA, xB) > this.width) return;
    // What lies far away does not tell lines apart.
    const place = (this.near(xA) + this.near(xB)) / 2;
    if (place - this.before < this.apart) return;
    this.before = place;
    this.path += bend(xA, xB, this.inset);
  }

  private near(x: number): number {
    return Math.min(2 * this.width, Math.max(-this.width, x));
  }
}

function xOf(timeS: number, { axis, frameTimeS }: RibbonClip): number {
  return axis.x(timeS / frameTimeS);
}

const px = (value: number): string => String(Math.round(value * 10) / 10);
