import { expect, test } from 'vitest';
import type { Point } from './hull';
import { PointGrid } from './point-grid';

test('it finds what a look at each point finds', () => {
  const points = Array.from({ length: 300 }, (_, k): Point => [
    ((k * 97) % 700) - 100,
    ((k * 61) % 500) - 100,
  ]);
  const grid = new PointGrid(points);
  let found = 0;
  for (let k = 0; k < 400; k += 1) {
    const [left, top] = [((k * 53) % 640) - 100, ((k * 37) % 460) - 100];
    const box = { left, top, right: left + 44, bottom: top + 12 };
    const reach = (k % 5) * 1.5;
    const expected = points.some(
      ([x, y]) =>
        x > box.left - reach &&
        x < box.right + reach &&
        y > box.top - reach &&
        y < box.bottom + reach,
    );
    expect(grid.isNear(box, reach)).toBe(expected);
    found += Number(expected);
  }
  expect(found).toBeGreaterThan(50);
  expect(found).toBeLessThan(350);
});

test('no points are nowhere', () => {
  expect(new PointGrid([]).isNear({ left: 0, top: 0, right: 9, bottom: 9 }, 5)).toBe(false);
});
