import { expect, test } from 'vitest';
import { zoomFactor } from './wheel-zoom';

const turn = { deltaY: -120, deltaMode: 0, ctrlKey: false, metaKey: false };

test('where the page does not scroll, the wheel makes larger and smaller', () => {
  expect(zoomFactor(turn, false)).toBeCloseTo(Math.exp(0.24));
  expect(zoomFactor({ ...turn, deltaY: 3, deltaMode: 1 }, false)).toBeCloseTo(Math.exp(-0.15));
});

test('where the page scrolls, the wheel is the page’s, but with Ctrl', () => {
  expect(zoomFactor(turn, true)).toBe(null);
  expect(zoomFactor({ ...turn, ctrlKey: true }, true)).toBeCloseTo(Math.exp(0.24));
  expect(zoomFactor({ ...turn, metaKey: true }, true)).toBeCloseTo(Math.exp(0.24));
});

test('two fingers on a touchpad, which tell small steps with Ctrl, are followed', () => {
  expect(zoomFactor({ ...turn, deltaY: -5, ctrlKey: true }, true)).toBeCloseTo(Math.exp(0.05));
});
