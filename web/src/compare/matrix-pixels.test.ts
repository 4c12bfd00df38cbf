import { expect, test } from 'vitest';
import { isExact, paintMatrix, type PlacedPicture } from './matrix-pixels';

const placed = (count: number, bins: number): PlacedPicture => ({
  region: {
    order: Int32Array.from({ length: count }, (_, k) => k),
    firstRow: 0,
    rowCount: count,
    firstColumn: 0,
    columnCount: count,
    most: bins,
  },
  picture: { rows: bins, columns: bins, values: new Float32Array(bins * bins) },
});

test('cells have their colour, the gap and the diagonal the background', () => {
  const out = new Uint32Array(9);
  const positions = Int32Array.of(0, -1, 1);
  paintMatrix(out, {
    placed: placed(2, 2),
    colours: Uint32Array.of(10, 11, 12, 13),
    rows: positions,
    columns: positions,
    background: 7,
  });
  expect([...out]).toEqual([7, 7, 11, 7, 7, 7, 12, 7, 7]);
});

test('a picture of means covers the positions evenly, its diagonal too', () => {
  const picture = placed(4, 2);
  expect(isExact(picture)).toBe(false);
  const out = new Uint32Array(16);
  const positions = Int32Array.of(0, 1, 2, 3);
  paintMatrix(out, {
    placed: picture,
    colours: Uint32Array.of(1, 2, 3, 4),
    rows: positions,
    columns: positions,
    background: 0,
  });
  expect([...out]).toEqual([1, 1, 2, 2, 1, 1, 2, 2, 3, 3, 4, 4, 3, 3, 4, 4]);
});

test('what the picture does not reach stays background', () => {
  const part = placed(2, 2);
  const out = new Uint32Array(2);
  const moved = { ...part, region: { ...part.region, firstColumn: 5 } };
  const painting = { placed: moved, colours: Uint32Array.of(1, 2, 3, 4), background: 9 };
  paintMatrix(out, { ...painting, rows: Int32Array.of(0), columns: Int32Array.of(4, 6) });
  expect([...out]).toEqual([9, 2]);
});
