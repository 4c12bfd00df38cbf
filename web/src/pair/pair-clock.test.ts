import { expect, test } from 'vitest';
import { alignedAt, alignedByPaths, alignedByStart } from './alignment';
import { PairClock } from './pair-clock';

const a = { frames: 101, frameTimeS: 0.01 };
const b = { frames: 61, frameTimeS: 0.05 };

function clockOf(alignment = alignedByStart([a, b])) {
  let changes = 0;
  const clock = new PairClock(() => changes++);
  clock.load([a, b], alignment);
  return { clock, frames: () => [...clock.moment().frames], changes: () => changes };
}

test('one time moves clips of different rates', () => {
  const { clock, frames, changes } = clockOf();
  clock.toggle();
  clock.advance(0.5);
  expect(frames()).toEqual([50, 10]);
  expect(changes()).toBeGreaterThan(1);
});

test('steps by frames of A, and where A has ended by those of B', () => {
  const { clock, frames } = clockOf();
  clock.seek(0, 99);
  clock.step(1);
  expect(frames()).toEqual([100, 20]);
  clock.step(1);
  expect(frames()).toEqual([100, 21]);
  clock.toEnd(1);
  clock.step(1);
  expect(frames()).toEqual([100, 60]);
  clock.seek(0, 30);
  clock.step(-1);
  expect(frames()).toEqual([29, 5]);
});

test('every frame of A is met by steps along a path that waits and leaps', () => {
  const pathA = [0, 1, 2, 2, 2, 3, 4, 5, 6];
  const pathB = [0, 0, 0, 1, 2, 3, 3, 4, 4];
  const short = { frames: 7, frameTimeS: 1 / 30 };
  const other = { frames: 5, frameTimeS: 1 / 24 };
  const clock = new PairClock(() => undefined);
  clock.load([short, other], alignedByPaths([short, other], [null, { pathA, pathB }]));
  const met = [clock.frameOf(0)];
  for (let i = 0; i < 6; i++) {
    clock.step(1);
    met.push(clock.frameOf(0));
  }
  expect(met).toEqual([0, 1, 2, 3, 4, 5, 6]);
});

test('another alignment leaves A where it is', () => {
  const { clock, frames } = clockOf();
  clock.seek(0, 40);
  clock.setSpeed(2);
  clock.load([a, b], alignedAt([a, b], [0.4, 1]));
  expect(frames()).toEqual([40, 20]);
  expect(clock.moment().speed).toBe(2);
});

test('goes from keypose to keypose of the clip asked for', () => {
  const { clock, frames } = clockOf();
  clock.keypose(1, Int32Array.of(12, 40), 1);
  expect(frames()).toEqual([60, 12]);
  clock.keypose(0, Int32Array.of(10, 80), -1);
  expect(frames()).toEqual([10, 2]);
  clock.keypose(0, Int32Array.of(10, 80), -1);
  expect(frames()).toEqual([10, 2]);
});

test('without clips it stands still', () => {
  const clock = new PairClock(() => undefined);
  clock.toggle();
  clock.step(1);
  expect(clock.moment().frames).toEqual([]);
  expect(clock.playing).toBe(false);
});

test('the loop stays at its moments of A under another alignment, and goes with another A', () => {
  const { clock } = clockOf();
  clock.setLoop({ fromS: 0.2, toS: 0.6 });
  clock.toggleLoop();
  clock.load([a, b], alignedAt([a, b], [0, 1]), undefined, true);
  const { loop, looping } = clock.moment();
  expect(loop?.fromS).toBeCloseTo(1.2, 9);
  expect(loop?.toS).toBeCloseTo(1.6, 9);
  expect(looping).toBe(false);
  clock.load([b, a], alignedByStart([b, a]));
  expect(clock.moment().loop).toBeNull();
});
