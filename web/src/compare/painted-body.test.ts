import { expect, test } from 'vitest';
import { barLength, barWidth } from './component-bars';
import { byShare, hasNegative, paintPercent } from './painted-body';

test('the largest share is painted whole, a negative one not at all', () => {
  expect(paintPercent(0.5, 0.5)).toBe(100);
  expect(paintPercent(0.25, 0.5)).toBe(59);
  expect(paintPercent(-0.1, 0.5)).toBe(0);
  expect(paintPercent(0, 0)).toBe(0);
});

test('parts from the largest share to the smallest', () => {
  const shares = {
    'left-arm': 0.1,
    'right-arm': 0.6,
    'left-leg': 0.1,
    'right-leg': -0.1,
    head: 0.3,
  };
  expect(hasNegative(shares)).toBe(true);
  expect(hasNegative({ ...shares, 'right-leg': -0.004 })).toBe(false);
  expect(byShare(shares)).toEqual(['right-arm', 'head', 'left-arm', 'left-leg', 'right-leg']);
});

test('a bar is as long as its share; a small one still shows', () => {
  expect(barLength(1)).toBe(barWidth);
  expect(barLength(0.5)).toBe(barWidth / 2);
  expect(barLength(0.003)).toBe(1.5);
  expect(barLength(0)).toBe(0);
});
