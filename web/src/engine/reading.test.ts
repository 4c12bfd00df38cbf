/** Numbers of rows as WebAssembly reads them, against JavaScript's own `Number`, to the bit. */
import { describe, expect, it } from 'vitest';
import { testCore } from './test-engine';

const WIDTH = 30;

const CHANNELS = Array.from({ length: WIDTH }, (_, index) => 'XYZ'.charAt(index % 3) + 'rotation');

const HEADER = `HIERARCHY
ROOT one
{
  OFFSET 0.0 0.0 0.0
  CHANNELS ${WIDTH} ${CHANNELS.join(' ')}
}
MOTION
`;

/** Random numbers from 0 to below 1, always the same ones (mulberry32). */
function random(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let word = Math.imul(state ^ (state >>> 15), 1 | state);
    word = (word + Math.imul(word ^ (word >>> 7), 61 | word)) ^ word;
    return ((word ^ (word >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** Words of every length and place of the point; seldom one with an exponent. */
function words(count: number): string[] {
  const next = random(7);
  return Array.from({ length: count }, () => {
    const value = (next() - 0.5) * 10 ** Math.floor(next() * 8);
    if (next() < 0.001) return value.toExponential();
    return value.toFixed(Math.floor(next() * 9));
  });
}

async function read(text: string, rows: number): Promise<Float64Array> {
  const clip = (await testCore()).newClip();
  const bytes = new TextEncoder().encode(text);
  clip.beginReading(bytes.length);
  clip.push(bytes);
  clip.endReading();
  const values = clip.rows(0, rows);
  clip.free();
  return values;
}

describe('numbers of rows', () => {
  it.each(['\n', '\r\n', ' \n'])('have the bits of Number, lines ending with %j', async (end) => {
    const rows = 4_000;
    const all = words(rows * WIDTH);
    const lines = Array.from({ length: rows }, (_, row) =>
      all.slice(row * WIDTH, (row + 1) * WIDTH).join(' '),
    );
    const text = `${HEADER}Frames: ${rows}\nFrame Time: 0.01\n${lines.join(end)}${end}`;
    const bits = new BigUint64Array((await read(text, rows)).buffer);
    const expected = new BigUint64Array(Float64Array.from(all, Number).buffer);
    expect(bits.length).toBe(expected.length);
    expect(bits.findIndex((word, index) => word !== expected[index])).toBe(-1);
  });
});
