/** The alignment of two clips and their axes in; the lines between matching moments out: pure geometry. */
import type { Axis } from '../timeline/axis';
import type { Alignment, ClipLength } from './alignment';
import { rows, ROWS_HEIGHT } from './rows-layout';

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

/** Places of A's moment and of B's. */
export type Places = readonly [xA: number, xB: number];

/** From where to where moments are marked: over A's rows, over B's, and over what is told on B's time. */
const overA = { top: rows.pinsA.top + 2, end: rows.ribbon.top };
const overB = { top: rows.speedB.top, end: rows.pinsB.top + rows.pinsB.height };
const beneath = { top: rows.ahead.top + 1, end: ROWS_HEIGHT };

/** SVG path data of a moment over the rows, bent across the ribbon. */
export function momentPath([xA, xB]: Places): string {
  const [a, b] = [px(xA), px(xB)];
  const onB = [overB, beneath].map(({ top, end }) => `M${b} ${top}V${end}`);
  return `M${a} ${overA.top}V${overA.end}${bend(xA, xB)}${onB.join('')}`;
}

/** SVG path data of all that lies between two moments. */
export function bandPath([fromA, fromB]: Places, [toA, toB]: Places): string {
  const [a0, b0, a1, b1] = [fromA, fromB, toA, toB].map(px);
  const [top, bottom] = [overA.end, overB.top];
  const down = `V${top}C${a0} ${top + BEND} ${b0} ${bottom - BEND} ${b0} ${bottom}`;
  const up = `V${bottom}C${b1} ${bottom - BEND} ${a1} ${top + BEND} ${a1} ${top}`;
  const both = `M${a0} ${overA.top}${down}V${overB.end}H${b1}${up}V${overA.top}Z`;
  return `${both}M${b0} ${beneath.top}V${beneath.end}H${b1}V${beneath.top}Z`;
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
