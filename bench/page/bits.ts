/** Whether two readings of the same rows have the same bits: a read clip and its text go in. */
import type { CoreClip } from '../../web/src/engine/raw';

/** Rows compared at a time: a long clip is never held twice. */
const ROWS_AT_ONCE = 2_000;

export interface BitsFound {
  readonly values: number;
  readonly different: number;
}

/** The lines of the rows, which follow the frame time. */
function rowLines(text: string): string[] {
  const start = text.indexOf('\n', text.indexOf('Frame Time')) + 1;
  return text
    .slice(start)
    .split('\n')
    .filter((line) => line.trim() !== '');
}

function differing(found: Float64Array<ArrayBuffer>, expected: Float64Array<ArrayBuffer>): number {
  if (found.length !== expected.length) return Math.max(found.length, expected.length);
  const bits = new BigUint64Array(expected.buffer);
  return new BigUint64Array(found.buffer).reduce(
    (count, word, index) => count + (word === bits[index] ? 0 : 1),
    0,
  );
}

/** Compares every value of a clip with JavaScript's own `Number` of its token. */
export function compareBits(clip: CoreClip, text: string): BitsFound {
  const lines = rowLines(text);
  let [values, different] = [0, 0];
  for (let first = 0; first < lines.length; first += ROWS_AT_ONCE) {
    const some = lines.slice(first, first + ROWS_AT_ONCE);
    const tokens = some.flatMap((line) => line.trim().split(/\s+/));
    const expected = Float64Array.from(tokens, Number);
    different += differing(clip.rows(first, some.length), expected);
    values += expected.length;
  }
  return { values, different };
}
