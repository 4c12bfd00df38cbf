import { expect, test } from 'vitest';
import { confusionExtent, confusionWindow, fieldPx, headPx } from './confusion-window';

const bar = 16;
const room = { left: 0, top: 0, width: 102 + 5 * 26 + bar, height: 18 + 6 * 21 + bar };

test('few labels stand whole, whatever the room', () => {
  expect(confusionWindow(5, { ...room, width: 0 })).toEqual({
    firstRow: 0,
    rowCount: 5,
    firstColumn: 0,
    columnCount: 5,
  });
});

test('of three thousand labels only what is in sight exists', () => {
  expect(confusionWindow(3000, room)).toEqual({
    firstRow: 0,
    rowCount: 6,
    firstColumn: 0,
    columnCount: 5,
  });
  const { firstRow, firstColumn } = confusionWindow(3000, { ...room, top: 2100, left: 260 });
  expect([firstRow, firstColumn]).toEqual([100, 10]);
});

test('scrolled to its end, the last label is in sight and nothing beyond', () => {
  const { width, height } = confusionExtent(100);
  for (const [spareWidth, spareHeight] of [
    [0, 0],
    [25, 20],
  ]) {
    const [w, h] = [room.width + spareWidth, room.height + spareHeight];
    for (const shownBar of [0, bar]) {
      const [left, top] = [width - w + shownBar, height - h + shownBar];
      const window = confusionWindow(100, { left, top, width: w, height: h });
      expect(window.firstRow + window.rowCount).toBe(100);
      expect(window.firstColumn + window.columnCount).toBe(100);
    }
  }
});

test('a room smaller than the heads still shows a field', () => {
  const { rowCount, columnCount } = confusionWindow(100, { left: 0, top: 0, width: 10, height: 0 });
  expect([rowCount, columnCount]).toEqual([1, 1]);
  expect(headPx.width + fieldPx.width).toBeGreaterThan(10);
});
