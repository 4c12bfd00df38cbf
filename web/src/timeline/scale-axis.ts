/** The vertical axis of the time scales, logarithmic in frequency: pure geometry. */
import type { Row } from './rows';

/** The finest scale, at the top, and the coarsest, at the foot, in Hz. */
export interface ScaleRange {
  readonly finestHz: number;
  readonly coarsestHz: number;
}

/** Air above the finest and below the coarsest scale. */
const AIR = 6;
const FOLDED_AIR = 4;

/**
 * The range of the parameters, so that clips can be compared although the extraction may end before the
 * coarsest scale; widened where the scales of an older result go beyond it.
 */
export function scaleRangeOf(scalesHz: ArrayLike<number>, wanted: ScaleRange | null): ScaleRange {
  const [first, last] = [scalesHz[0] ?? 1, scalesHz[scalesHz.length - 1] ?? 1];
  if (wanted === null) return { finestHz: first, coarsestHz: last };
  if (scalesHz.length === 0) return wanted;
  return {
    finestHz: Math.max(wanted.finestHz, first),
    coarsestHz: Math.min(wanted.coarsestHz, last),
  };
}

/** Height of a frequency, in pixels from the timeline's upper edge. */
export function scaleY(row: Row, hz: number, { finestHz, coarsestHz }: ScaleRange): number {
  const octaves = Math.log(coarsestHz / finestHz);
  const part = octaves === 0 ? 0 : Math.log(hz / finestHz) / octaves;
  const air = row.folded ? FOLDED_AIR : AIR;
  return row.top + air + part * (row.height - 2 * air);
}
