import { expect, test } from 'vitest';
import { pictureLegend, textPx } from './picture-legend';
import type { ComparePalette } from './compare-palette';
import type { Scene } from './scene';

const palette = { labels: ['#111'], panel: '#fff', text2: '#222' } as unknown as ComparePalette;
const sceneWith = (labels: readonly string[], used = labels.map((_, index) => index)): Scene =>
  ({ labels, labelOfItem: Int32Array.from(used) }) as unknown as Scene;

const placesOf = (svg: string): { x: number; y: number; text: string }[] =>
  [...svg.matchAll(/<text x="([\d.]+)" y="([\d.]+)"[^>]*>([^<]*)</g)].map(([, x, y, text]) => ({
    x: Number(x),
    y: Number(y),
    text,
  }));

test('many labels take several lines, none beyond the width', () => {
  const labels = Array.from({ length: 40 }, (_, index) => `label ${index}`);
  const legend = pictureLegend(sceneWith(labels), 400);
  const places = placesOf(legend.tags(palette, 20, 100));
  expect(places.map(({ text }) => text)).toEqual(labels);
  for (const { x, y, text } of places) {
    expect(x + textPx(text)).toBeLessThanOrEqual(420 + 5);
    expect(y).toBeLessThan(100 + legend.heightPx);
  }
  expect(new Set(places.map(({ y }) => y)).size).toBe(legend.heightPx / 18);
});

test('a name wider than the picture loses its middle', () => {
  const name = `begin${'x'.repeat(200)}end`;
  const [{ text }] = placesOf(pictureLegend(sceneWith([name]), 200).tags(palette, 0, 0));
  expect(text).toMatch(/^begin.*….*end$/);
  expect(textPx(text)).toBeLessThanOrEqual(190);
});

test('labels that no clip of the set has are left out; without labels there is no legend', () => {
  const used = pictureLegend(sceneWith(['a', 'b', 'c'], [-1, 1]), 200);
  expect(placesOf(used.tags(palette, 0, 0)).map(({ text }) => text)).toEqual(['b']);
  expect(pictureLegend(sceneWith([]), 200).heightPx).toBe(0);
});
