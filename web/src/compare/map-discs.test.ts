import { expect, test } from 'vitest';
import { stamp } from './map-discs';

const opaque = (value: number): number => (0xff000000 | value) >>> 0;
const disc = { width: 2, pixels: Uint32Array.of(opaque(1), opaque(2), 0, opaque(4)) };

test('a stamp covers what it is opaque over, and leaves the rest', () => {
  const image = new Uint32Array(9).fill(opaque(9));
  stamp(image, 3, disc, 1, 1);
  expect([...image]).toEqual([1, 2, 9, 9, 4, 9, 9, 9, 9].map(opaque));
});

test('what lies outside the image is cut off', () => {
  const image = new Uint32Array(4);
  stamp(image, 2, disc, 0, 0);
  expect([...image]).toEqual([opaque(4), 0, 0, 0]);
  stamp(image, 2, disc, 20, 20);
  stamp(image, 2, disc, -20, -20);
  expect([...image]).toEqual([opaque(4), 0, 0, 0]);
});

test('a half clear pixel is mixed with what is under it', () => {
  const image = Uint32Array.of(opaque(0));
  stamp(image, 1, { width: 1, pixels: Uint32Array.of((128 << 24) | 200) }, 0.5, 0.5);
  expect(image[0] >>> 24).toBe(255);
  expect(image[0] & 255).toBe(100);
});
