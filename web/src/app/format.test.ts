import { expect, test } from 'vitest';
import { createFormat } from './format';
import { estimateSecondsLeft } from './time-left';

const en = createFormat('en');

test('figures keep their digits', () => {
  expect(en.decimal(2.8, 3)).toBe('2.800');
  expect(en.short(120.00048, 2)).toBe('120');
  expect(en.short(59.94, 2)).toBe('59.94');
  expect(en.integer(1096)).toBe('1,096');
});

test('a place has the ending of its number, in English', () => {
  const places = [1, 2, 3, 4, 11, 12, 13, 21, 102, 1011].map((place) => en.ordinal(place));
  const told = ['1st', '2nd', '3rd', '4th', '11th', '12th', '13th', '21st', '102nd', '1,011th'];
  expect(places).toEqual(told);
  expect(createFormat('ja').ordinal(21)).toBe('21');
});

test('a length is told in seconds, then as a clock', () => {
  expect(en.duration(9.13)).toEqual({ text: '9.1', inSeconds: true });
  expect(en.duration(725)).toEqual({ text: '12:05', inSeconds: false });
  expect(en.duration(3600)).toEqual({ text: '1:00:00', inSeconds: false });
});

test('a probability is told as the next power of ten that it is below', () => {
  expect(en.probability(0.0123)).toBe('= 0.012');
  expect(en.probability(3e-17)).toBe('< 10⁻¹⁶');
  expect(en.probability(0)).toBe('< 10⁻³⁰⁰');
});

test('sizes have the unit that fits', () => {
  expect(en.bytes(15_500_000)).toBe('15.5 MB');
  expect(en.bytes(837_000)).toBe('837 kB');
});

test('time left is told once there is something to go by', () => {
  expect(estimateSecondsLeft(0.1, 50, 100)).toBeNull();
  expect(estimateSecondsLeft(2, 1, 100)).toBeNull();
  expect(estimateSecondsLeft(2, 25, 100)).toBeCloseTo(6);
});
