import { expect, test } from 'vitest';
import { filmTimes } from './film-times';

const moments = ({ count, momentS }: ReturnType<typeof filmTimes>): number[] =>
  Array.from({ length: count }, (_, picture) => momentS(picture));

test('a picture stands for every n / rate from the first moment to the last, both among them', () => {
  const times = filmTimes({ fromS: 1, toS: 1.5, speed: 1 }, 4);
  expect(moments(times)).toEqual([1, 1.25, 1.5]);
  expect(times.lengthS).toBe(0.75);
});

test('an end between two pictures is not shown, nor is one beyond the end', () => {
  expect(moments(filmTimes({ fromS: 0, toS: 0.6, speed: 1 }, 4))).toEqual([0, 0.25, 0.5]);
});

test('rounding neither loses nor adds a picture', () => {
  for (const rate_hz of [25, 30, 60])
    for (let whole = 1; whole < 500; whole++)
      expect(filmTimes({ fromS: 0.1, toS: 0.1 + whole / rate_hz, speed: 1 }, rate_hz).count).toBe(
        whole + 1,
      );
});

test('at half the speed the film is twice as long and no moment is left out', () => {
  const times = filmTimes({ fromS: 0, toS: 1, speed: 0.5 }, 2);
  expect(moments(times)).toEqual([0, 0.25, 0.5, 0.75, 1]);
  expect(times.lengthS).toBe(2.5);
});

test('a moment is a film of one picture', () => {
  expect(moments(filmTimes({ fromS: 2, toS: 2, speed: 1 }, 30))).toEqual([2]);
});
