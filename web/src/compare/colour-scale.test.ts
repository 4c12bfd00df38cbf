import { expect, test } from 'vitest';
import { ColourScale, pixelOf, rgbOf } from './colour-scale';

const stops = ['#261c60', '#46a0b5', '#f3f8f7'];

test('the ends are the first and the last stop, and larger distances are clipped', () => {
  const scale = new ColourScale(stops, 0.06);
  expect(scale.css(0)).toBe('#261c60');
  expect(scale.css(0.06)).toBe('#f3f8f7');
  expect(scale.css(1)).toBe('#f3f8f7');
});

test('the scale is a square root: a quarter of the maximum is half way', () => {
  const [red, green, blue] = rgbOf(new ColourScale(stops, 4).css(1));
  const middle = rgbOf('#46a0b5');
  [red, green, blue].forEach((byte, k) => expect(Math.abs(byte - middle[k])).toBeLessThan(2));
});

test('clips that are all the same have the colour of alike', () => {
  expect(new ColourScale(stops, 0).css(0)).toBe('#261c60');
});

test('a pixel has its bytes in the order of image data', () => {
  expect(new Uint8Array(Uint32Array.of(pixelOf([1, 2, 3])).buffer)).toEqual(
    Uint8Array.of(1, 2, 3, 255),
  );
});

test('many distances at once have the colours that each has', () => {
  const scale = new ColourScale(['#ffffff', '#808080', '#000000'], 0.3);
  const distances = Float32Array.from({ length: 500 }, (_, k) => k / 1000);
  const each = Array.from(distances, (distance) => scale.pixel(distance));
  expect([...scale.pixelsOf(distances)]).toEqual(each);
  const flat = new ColourScale(['#ffffff', '#000000'], 0);
  expect(flat.pixelsOf(Float32Array.of(0, 1))[1]).toBe(flat.pixel(1));
});
