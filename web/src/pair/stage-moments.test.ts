import { expect, it } from 'vitest';
import { keyposesAround } from './stage-moments';

const keyposes = Int32Array.of(10, 20, 30, 40, 50);
const numbers = (current: number | null, together?: number): number[] =>
  keyposesAround(keyposes, current, together).map(({ number }) => number);

it('shows two keyposes on either side, or as many as there are', () => {
  expect(numbers(2)).toEqual([1, 2, 4, 5]);
  expect(numbers(0)).toEqual([2, 3]);
  expect(numbers(null)).toEqual([]);
});

it('shows one on either side where many clips share a stage', () => {
  expect(numbers(2, 4)).toEqual([1, 2, 4, 5]);
  expect(numbers(2, 20)).toEqual([2, 4]);
});
