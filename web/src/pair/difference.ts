/** Distances of body parts along a warping path, B's axis in; a shade 0 … 1 for every pixel out. Pure. */
import type { Warping } from '../engine/comparison-types';
import { bodyParts } from '../engine/types';
import type { Axis } from '../timeline/axis';

export interface DifferenceShades {
  /** The pixel of the first column. */
  readonly left: number;
  readonly columns: number;
  /** Parts × columns; 1 is the full colour. */
  readonly shades: Float32Array;
}

/** The mean of the steps that B's frames under a pixel have; between frames, those of the frame before. */
export function differenceShades(warping: Warping, axis: Axis): DifferenceShades {
  const { pathB, partDistances, fullColour } = warping;
  const steps = pathB.length;
  if (steps === 0) return { left: 0, columns: 0, shades: new Float32Array() };
  const left = Math.round(axis.x(pathB[0]));
  const columns = Math.max(1, Math.round(axis.x(pathB[steps - 1] + 1)) - left);
  const sums = new Float64Array(columns * bodyParts.length);
  const counts = new Int32Array(columns);
  for (let step = 0; step < steps; step++) {
    const column = Math.min(columns - 1, Math.max(0, Math.round(axis.x(pathB[step])) - left));
    counts[column]++;
    for (let part = 0; part < bodyParts.length; part++)
      sums[part * columns + column] += partDistances[step * bodyParts.length + part];
  }
  return { left, columns, shades: shadesOf(sums, counts, fullColour) };
}

function shadesOf(sums: Float64Array, counts: Int32Array, fullColour: number): Float32Array {
  const columns = counts.length;
  const shades = new Float32Array(sums.length);
  for (let at = 0; at < sums.length; at++) {
    const column = at % columns;
    const mean = counts[column] > 0 ? sums[at] / counts[column] / (fullColour || 1) : null;
    shades[at] = mean === null ? (column > 0 ? shades[at - 1] : 0) : Math.min(1, mean);
  }
  return shades;
}
