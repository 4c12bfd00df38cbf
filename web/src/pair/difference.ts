/** Distances of body parts along a warping path, B's axis in; a shade 0 … 1 for every pixel out. Pure. */
import type { Warping } from '../engine/comparison-types';
import { bodyParts } from '../engine/types';
import type { Axis } from '../timeline/axis';
import { within } from '../timeline/sorted';

export interface DifferenceShades {
  /** The pixel of the first column. */
  readonly left: number;
  readonly columns: number;
  /** Parts × columns; 1 is the full colour. */
  readonly shades: Float32Array;
}

/**
 * The mean of the steps that B's frames under a pixel have, for the pixels in view; between frames, those
 * of the frame before.
 */
export function differenceShades(warping: Warping, axis: Axis): DifferenceShades {
  const { pathB, partDistances, fullColour } = warping;
  const steps = pathB.length;
  const left = steps > 0 ? Math.max(0, Math.round(axis.x(pathB[0]))) : 0;
  const right = steps > 0 ? Math.round(axis.x(pathB[steps - 1] + 1)) : 0;
  const columns = Math.min(Math.ceil(axis.width), Math.max(left + 1, right)) - left;
  if (columns <= 0 || steps === 0 || right < 0) return { left: 0, columns: 0, shades: none };
  const sums = new Float64Array(columns * bodyParts.length);
  const counts = new Int32Array(columns);
  const { from, to } = stepsInView(pathB, axis.placeAt(left), axis.placeAt(left + columns));
  for (let step = from; step < to; step++) {
    const column = Math.min(columns - 1, Math.max(0, Math.round(axis.x(pathB[step])) - left));
    counts[column]++;
    for (let part = 0; part < bodyParts.length; part++)
      sums[part * columns + column] += partDistances[step * bodyParts.length + part];
  }
  return { left, columns, shades: shadesOf(sums, counts, fullColour) };
}

const none = new Float32Array();

/** The steps of frames first … last, and of the frame before them. */
function stepsInView(pathB: Int32Array, first: number, last: number) {
  const { from, to } = within(pathB, first, last);
  const before = pathB[Math.max(0, from - 1)];
  return { from: Math.min(from, within(pathB, before, before).from), to };
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
