import { expect, test } from 'vitest';
import { beside } from './beside-layout';

const window = { width: 1000, height: 800 };
const panel = { width: 300, height: 200 };
const button = { left: 600, right: 700, top: 400, bottom: 428 };

test('stands above or below, one edge with the button', () => {
  const at = (side: 'above' | 'below', edge: 'left' | 'right') =>
    beside(button, panel, window, { side, edge });
  expect(at('below', 'left')).toEqual({ left: 600, top: 432 });
  expect(at('below', 'right')).toEqual({ left: 400, top: 432 });
  expect(at('above', 'right')).toEqual({ left: 400, top: 196 });
});

test('changes sides where there is no room', () => {
  const low = { ...button, top: 760, bottom: 788 };
  expect(beside(low, panel, window, { side: 'below', edge: 'right' }).top).toBe(556);
  const high = { ...button, top: 10, bottom: 38 };
  expect(beside(high, panel, window, { side: 'above', edge: 'right' }).top).toBe(42);
});

test('is always in the window, its beginning where the window is too small', () => {
  const beyond = { ...button, left: 900, right: 990 };
  expect(beside(beyond, panel, window, { side: 'below', edge: 'left' }).left).toBe(696);
  const tall = { width: 1200, height: 700 };
  expect(beside(button, tall, window, { side: 'below', edge: 'left' })).toEqual({
    left: 4,
    top: 96,
  });
  expect(
    beside(button, tall, { width: 320, height: 480 }, { side: 'above', edge: 'right' }),
  ).toEqual({ left: 4, top: 4 });
});
