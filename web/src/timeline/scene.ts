/** What a row needs to be drawn: where, what and in which colours. */
import type { Axis } from './axis';
import type { Palette } from './palette';
import type { RowLayout } from './rows';
import { scaleRangeOf, scaleY, type ScaleRange } from './scale-axis';
import { within, type Run } from './sorted';
import type { TimelineData } from './timeline-data';

/** Pixels beside the axis from which something may still reach into it. */
const OVERHANG = 12;

export interface Scene {
  readonly axis: Axis;
  readonly rows: RowLayout;
  readonly data: TimelineData;
  readonly palette: Palette;
  readonly scaleRange: ScaleRange;
  /** Heights of all scales, by their index. */
  readonly scaleHeights: Float64Array;
  /** The keyposes and the candidates in view. */
  readonly keyposes: Run;
  readonly candidates: Run;
}

/** @param wanted the range of scales to show; null: that of the result */
export function sceneOf(
  axis: Axis,
  rows: RowLayout,
  data: TimelineData,
  palette: Palette,
  wanted: ScaleRange | null,
): Scene {
  const first = axis.placeAt(-OVERHANG);
  const last = axis.placeAt(axis.width + OVERHANG);
  const { scalesHz, candidates } = data.result;
  const scaleRange = scaleRangeOf(scalesHz, wanted);
  return {
    axis,
    rows,
    data,
    palette,
    scaleRange,
    scaleHeights: scalesHz.map((hz) => scaleY(rows.scales, hz, scaleRange)),
    keyposes: within(data.frames, first, last),
    candidates: within(candidates, first, last),
  };
}

/** Keyposes closer than this on average would make one wash of their stems and traces, in pixels. */
const LEAST_DISTANCE = 5;

/** Whether each keypose in view can have a stem, a ribbon and a round dot of its own. */
export function isSparse({ axis, keyposes }: Scene): boolean {
  return (keyposes.to - keyposes.from) * LEAST_DISTANCE <= axis.width;
}
