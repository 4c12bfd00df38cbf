import { beforeAll, expect, test } from 'vitest';
import type { ComparisonCore } from './comparison-raw';
import { at, average, comparerAround, ward, withPlaces } from './test-comparer';
import { testComparisonCore } from './test-engine';

let core: ComparisonCore;
beforeAll(async () => {
  core = await testComparisonCore();
});

const setUp = () => comparerAround(core);

/** Gower's formula on the map of a line, whose second axis has no spread: the foot on the line. */
function footOnLine(map: Float64Array, places: readonly number[], place: number): number {
  const middle = (values: readonly number[]): number =>
    values.reduce((sum, value) => sum + value, 0) / values.length;
  const xs = places.map((_, item) => map[2 * item]);
  const [x0, p0] = [middle(xs), middle(places)];
  const terms = places.map((one, item) => ({
    x: xs[item] - x0,
    square: (one - p0) ** 2,
    d: one - place,
  }));
  const spread = terms.reduce((sum, { x }) => sum + x * x, 0);
  return x0 + terms.reduce((sum, { x, square, d }) => sum + (x * (square - d * d)) / 2, 0) / spread;
}

test('a clip told since is placed by the formula, and what lay there stays', async () => {
  const { comparer } = setUp();
  const line = [0, 3, 4, 9];
  const { map } = await withPlaces(comparer, line).compare(ward);
  expect([...(await comparer.arrivals()).clips]).toEqual([]);
  comparer.setFeature(7, 'clip 7', at(6));
  comparer.setFeature(5, 'clip 5', at(-20));
  const { clips, places } = await comparer.arrivals();
  expect([...clips]).toEqual([5, 7]);
  expect(places[0]).toBeCloseTo(footOnLine(map, line, -20), 12);
  expect(places[2]).toBeCloseTo(footOnLine(map, line, 6), 12);
  const kept = await comparer.compare(average, { keepsPlaces: true });
  expect([...kept.clips]).toEqual([0, 1, 2, 3, 5, 7]);
  expect([...kept.map]).toEqual([...map, ...places]);
  expect([...(await comparer.arrivals()).clips]).toEqual([]);
  comparer.destroy();
});

test('clips that the places kept would show in a heap are laid out anew', async () => {
  const { comparer } = setUp();
  const line = [0, 3, 4, 9];
  const { map } = await withPlaces(comparer, line).compare(ward);
  line.forEach((place, k) => {
    const far = at(place);
    far.recorded[1] = 30 + k;
    comparer.setFeature(10 + k, 'far', far);
  });
  const heap = (await comparer.arrivals()).places;
  expect(Math.abs(heap[0] - map[0])).toBeLessThan(1e-9);
  const all = await comparer.compare(ward, { keepsPlaces: true });
  expect(Math.hypot(all.map[8] - all.map[0], all.map[9] - all.map[1])).toBeCloseTo(30, 6);
  expect(all.spread).toBeCloseTo(1, 9);
  comparer.destroy();
});

test('another distance lays out anew, also where places would be kept', async () => {
  const { comparer } = setUp();
  const { map } = await withPlaces(comparer, [0, 3, 4, 9]).compare(average);
  const settings = { ...average, distance: { ...average.distance, mirrorAware: true } };
  const bent = at(5);
  bent.recorded[3] = 8;
  comparer.setFeature(1, 'clip 1', bent);
  const mirrored = await comparer.compare(settings, { keepsPlaces: true });
  expect([...mirrored.map]).not.toEqual([...map]);
  const image = at(5);
  image.recorded[3] = -8;
  comparer.setFeature(6, 'clip 6', image);
  const { places } = await comparer.arrivals();
  expect(places[0]).toBeCloseTo(mirrored.map[2], 9);
  expect(places[1]).toBeCloseTo(mirrored.map[3], 9);
  comparer.destroy();
});

test('a full layout lies as clips lay, those that had arrived too', async () => {
  const { comparer } = setUp();
  const { map } = await withPlaces(comparer, [0, 3, 4, 9]).compare(ward);
  comparer.setFeature(4, 'clip 4', at(100));
  await comparer.arrivals();
  const full = await comparer.compare(ward);
  const way = (places: Float64Array): number => Math.sign(places[6] - places[0]);
  expect(way(full.map)).toBe(way(map));
  expect(full.map[8] - full.map[0]).toBeCloseTo(100 * way(map), 9);
  comparer.destroy();
});

test('the map of a replaced worker lies as that of the one before', async () => {
  const { comparer, deaths } = setUp();
  withPlaces(comparer, [0, 3, 4, 9]);
  await comparer.compare(ward);
  // The far clip turns the map's own axis: only its place tells which way it lay.
  comparer.setFeature(4, 'clip 4', at(-100));
  const before = await comparer.compare(ward);
  deaths[0]?.('gone');
  comparer.setFeature(5, 'clip 5', at(3));
  const { clips, places } = await comparer.arrivals();
  expect([...clips]).toEqual([5]);
  expect(places[0]).toBeCloseTo(before.map[2], 9);
  comparer.destroy();
});
