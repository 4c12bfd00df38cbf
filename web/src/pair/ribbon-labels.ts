/** The axes of A and B in; the times at the edges of the ribbon, where nothing covers them, out: pure geometry. */
import { Axis } from '../timeline/axis';
import {
  clockTime,
  divisionOf,
  rulerTicks,
  type Division,
  type Tick,
} from '../timeline/ruler-layout';

export interface RibbonTicks {
  readonly ticks: readonly Tick[];
  readonly division: Division;
}

export interface RibbonLabel {
  readonly x: number;
  readonly text: string;
}

/** Pixels of a letter, between a tick and its label, and from the middle of a flag to its edge. */
const LETTER = 6;
const GAP = 4;
const FLAG_HALF_WIDTH = 25;
const TAB_WIDTH = 16;

/** The labels stand among lines: half as many as a ruler would have, but two at least. */
export function ribbonTicks(axis: Axis, frameTimeS: number): RibbonTicks {
  const narrow = new Axis(axis.width / 2, axis.lastFrame, axis.span);
  const { first, last } = axis.span;
  const few = divisionOf(narrow, frameTimeS);
  const fewS = few.unit === 'frames' ? few.labelled * frameTimeS : few.labelled;
  const isEnough = (last - first) * frameTimeS >= 2 * fewS;
  const division = isEnough ? few : divisionOf(axis, frameTimeS);
  return { ticks: rulerTicks(axis, frameTimeS, division), division };
}

export function ribbonLabels(
  { ticks, division }: RibbonTicks,
  width: number,
  withUnit: (seconds: string) => string,
): RibbonLabel[] {
  return ticks
    .filter(({ size, timeS }) => size === 'major' && timeS > 0)
    .map(({ x, timeS }) => ({
      x: x + GAP,
      text: timeText(timeS, division.digits, withUnit),
    }))
    .filter(({ x, text }) => x + text.length * LETTER <= width);
}

const timeText = (timeS: number, digits: number, withUnit: (seconds: string) => string): string =>
  timeS < 59.9995 ? withUnit(timeS.toFixed(digits)) : clockTime(timeS, digits);

/** What covers labels, from pixel to pixel. */
export type Cover = readonly [from: number, to: number];

export const flagCover = (x: number): Cover => [x - FLAG_HALF_WIDTH, x + FLAG_HALF_WIDTH];

/** The tabs of a loop between two pixels. */
export const tabCovers = (from: number, to: number): Cover[] => [
  [from, from + TAB_WIDTH],
  [to - TAB_WIDTH, to],
];

export function uncovered(labels: readonly RibbonLabel[], covers: readonly Cover[]): RibbonLabel[] {
  return labels.filter(({ x, text }) =>
    covers.every(([from, to]) => x > to || x + text.length * LETTER < from),
  );
}
