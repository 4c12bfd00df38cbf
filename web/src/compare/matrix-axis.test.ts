import { expect, test } from 'vitest';
import { MatrixAxis, fitAxis, positionsUnder } from './matrix-axis';

const six = Int32Array.of(0, 0, 1, 1, 1, 2);

test('cells are as large as the room allows, and no larger than 18', () => {
  expect(fitAxis(six, 100)).toEqual({ cell: 15, gap: 4 });
  expect(fitAxis(six, 1000)).toEqual({ cell: 18, gap: 4 });
});

test('thirty-nine clips in six clusters have cells of 13 in the room of the page', () => {
  const groups = Int32Array.from({ length: 39 }, (_, k) => Math.floor(k / 6.5));
  expect(fitAxis(groups, 550)).toEqual({ cell: 13, gap: 4 });
});

test('thousands of clips have cells under a pixel, and gaps never take the room', () => {
  const groups = Int32Array.from({ length: 3000 }, (_, k) => Math.floor(k / 10));
  const { cell, gap } = fitAxis(groups, 550);
  expect(gap).toBe(0);
  expect(cell).toBeCloseTo(550 / 3000);
});

test('a pixel belongs to a cell, or to none in a gap and outside', () => {
  const axis = new MatrixAxis(six, { cell: 10, gap: 4 });
  expect([axis.start(1), axis.start(2), axis.start(5)]).toEqual([10, 24, 58]);
  expect(axis.length).toBe(68);
  expect([axis.at(0), axis.at(19.9), axis.at(20), axis.at(24), axis.at(67.9)]).toEqual([
    0, 1, -1, 2, 5,
  ]);
  expect([axis.at(-1), axis.at(68)]).toEqual([-1, -1]);
  expect([axis.nearest(-5), axis.nearest(21), axis.nearest(500)]).toEqual([0, 1, 5]);
});

test('device pixels are told their positions', () => {
  const axis = new MatrixAxis(Int32Array.of(0, 1), { cell: 2, gap: 1 });
  expect([...positionsUnder(axis, 0, 6, 1)]).toEqual([0, 0, -1, 1, 1, -1]);
  expect([...positionsUnder(axis, 3, 4, 2)]).toEqual([1, 1, 1, 1]);
});

test('without clips there is nothing', () => {
  const axis = new MatrixAxis(new Int32Array(), fitAxis(new Int32Array(), 500));
  expect(axis.length).toBe(0);
  expect(axis.at(0)).toBe(-1);
});
