import { expect, test } from 'vitest';
import type { MethodSettings } from '../engine/types';
import { parseNumber, refusalOf, scaleCount, stepped, type NumberKey } from './parameter-values';

const defaults: MethodSettings = {
  lowPassHz: 10,
  scaleMaxHz: 8,
  scaleMinHz: 0.2,
  scaleRatio: 0.95,
  selection: 'automatic',
};

test('numbers as people write them', () => {
  expect([' 10 ', '0,95', '.5', '1e-1', '-3', '7.'].map(parseNumber)).toEqual([
    10, 0.95, 0.5, 0.1, -3, 7,
  ]);
  expect(
    ['', ' ', '.', 'ten', '1,000.5', '1,2,3', 'Infinity', '0x10', '5 Hz'].map(parseNumber),
  ).toEqual(Array(9).fill(NaN));
});

test('the defaults are 72 scales, and are not refused', () => {
  expect(scaleCount(defaults)).toBe(72);
  for (const key of ['lowPassHz', 'scaleMaxHz', 'scaleMinHz', 'scaleRatio'] as const)
    expect(refusalOf(defaults, key)).toBeNull();
});

const refused: readonly (readonly [NumberKey, number, string])[] = [
  ['lowPassHz', 0, 'wrong.frequency'],
  ['lowPassHz', 100_001, 'wrong.frequency'],
  ['lowPassHz', NaN, 'wrong.frequency'],
  ['scaleMaxHz', 0.1, 'wrong.below-coarsest'],
  ['scaleMinHz', 9, 'wrong.above-finest'],
  ['scaleMinHz', -1, 'wrong.frequency'],
  ['scaleRatio', 1, 'wrong.ratio'],
  ['scaleRatio', 0, 'wrong.ratio'],
  ['scaleRatio', 0.9999, 'wrong.scales'],
];

test.each(refused)('%s cannot be %f: %s', (key, value, why) => {
  expect(refusalOf({ ...defaults, [key]: value }, key)?.key).toBe(why);
});

test('a range that another parameter makes too long is refused too', () => {
  const many = { ...defaults, scaleRatio: 0.995 };
  expect(refusalOf(many, 'scaleRatio')).toBeNull();
  expect(refusalOf({ ...many, scaleMinHz: 0.01 }, 'scaleMinHz')?.values).toEqual([1334, 1000]);
  expect(refusalOf({ ...many, scaleMinHz: 0.01 }, 'lowPassHz')).toBeNull();
});

test('one scale is enough', () => {
  expect(refusalOf({ ...defaults, scaleMinHz: 8 }, 'scaleMinHz')).toBeNull();
  expect(scaleCount({ ...defaults, scaleMinHz: 8 })).toBe(1);
});

test('steps leave no binary dust', () => {
  expect(stepped(0.2, 0.1)).toBe(0.3);
  expect(stepped(0.95, -0.01)).toBe(0.94);
  expect(stepped(9.5, 1)).toBe(10.5);
  expect(stepped(10, -1)).toBe(9);
});
