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

/** Keyposes closer than this on average would make one wash of their traces, in pixels. */
const LEAST_MEAN_DISTANCE = 5;
/** A keypose nearer to the next than this has no stem. */
const LEAST_DISTANCE = 8;

/** Whether the keyposes in view can have ribbons and round dots. */
export function isSparse({ axis, keyposes }: Scene): boolean {
  return (keyposes.to - keyposes.from) * LEAST_MEAN_DISTANCE <= axis.width;
}

/** The keyposes in view that stand apart from their neighbours: those with a stem and a dot on the curve. */
export function standingApart({ axis, data, keyposes }: Scene): number[] {
  const apart: number[] = [];
  for (let keypose = keyposes.from; keypose < keyposes.to; keypose++)
    if (data.gaps[keypose] * axis.scale >= LEAST_DISTANCE) apart.push(keypose);
  return apart;
}
