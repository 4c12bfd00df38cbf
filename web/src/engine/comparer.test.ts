import { beforeAll, expect, test } from 'vitest';
import type { ComparisonCore } from './comparison-raw';
import { at, average, comparerAround, ward, withPlaces } from './test-comparer';
import { testComparisonCore } from './test-engine';

let core: ComparisonCore;
beforeAll(async () => {
  core = await testComparisonCore();
});

const setUp = () => comparerAround(core);

test('no worker before the first comparison, one for all', async () => {
  const { comparer, workers } = setUp();
  withPlaces(comparer, [0, 1]);
  expect(workers).toHaveLength(0);
  await comparer.compare(ward);
  await comparer.neighbours(0, 5);
  expect(workers).toHaveLength(1);
  comparer.destroy();
});

test('clips that are near are joined first, their cut and neighbours agree', async () => {
  const { comparer } = setUp();
  const comparison = await withPlaces(comparer, [0, 10, 1, 12]).compare(average);
  expect([...comparison.clips]).toEqual([0, 1, 2, 3]);
  expect(comparison.pairs).toBe(6);
  expect([...comparison.tree.heights]).toEqual([1, 2, 10.5]);
  expect([...comparison.nearest]).toEqual([2, 3, 0, 1]);
  expect([...comparison.nearestDistances]).toEqual([1, 2, 1, 2]);
  const cut = await comparer.cut(2);
  expect(cut.clusters).toBe(2);
  expect(cut.clusterOfItem[0]).toBe(cut.clusterOfItem[2]);
  expect(cut.clusterOfItem[0]).not.toBe(cut.clusterOfItem[1]);
  expect(await comparer.neighbours(0, 2)).toEqual([
    { clip: 2, distance: 1, mirrored: false },
    { clip: 1, distance: 10, mirrored: false },
  ]);
  comparer.destroy();
});

test('a feature that changes or goes is told with the next comparison', async () => {
  const { comparer } = setUp();
  await withPlaces(comparer, [0, 1, 2]).compare(ward);
  comparer.setFeature(1, 'clip 1', null);
  comparer.setFeature(2, 'clip 2', at(7));
  const comparison = await comparer.compare(ward);
  expect([...comparison.clips]).toEqual([0, 2]);
  expect(comparison.maximum).toBe(7);
  comparer.destroy();
});

test('a newer comparison cancels an older one', async () => {
  const { comparer } = setUp();
  const places = Array.from({ length: 300 }, (_, index) => Math.sin(index));
  const older = withPlaces(comparer, places).compare(average);
  const newer = comparer.compare(ward);
  await expect(older).rejects.toMatchObject({ name: 'AbortError' });
  expect((await newer).settings.linkage).toBe('ward');
  comparer.destroy();
});

test('a picture of the matrix, and one asked for while it is compared again', async () => {
  const { comparer } = setUp();
  const { tree } = await withPlaces(comparer, [0, 10, 1]).compare(average);
  const all = {
    order: tree.leaves,
    firstRow: 0,
    rowCount: 3,
    firstColumn: 0,
    columnCount: 3,
    most: 3,
  };
  const { rows, columns, values } = await comparer.picture(all);
  expect([rows, columns]).toEqual([3, 3]);
  expect(Math.max(...values)).toBe(10);
  const [picture] = await Promise.all([comparer.picture(all), comparer.compare(ward)]);
  expect(picture.rows).toBe(3);
  comparer.destroy();
});

test('labels: the nearest, the confusion, and a label with one clip', async () => {
  const { comparer } = setUp();
  await withPlaces(comparer, [0, 1, 10, 11, 30]).compare(average);
  const found = await comparer.evaluate({ clusters: 3, labels: ['a', 'a', 'b', 'a', 'c'] });
  expect(found.labels).toEqual(['a', 'b', 'c']);
  expect(found.labelled).toBe(5);
  expect(found.correct).toBe(2);
  const fields = [...found.confusion].sort(([a, b], [c, d]) => a - c || b - d);
  expect(fields).toEqual([
    [0, 0, 2],
    [0, 1, 1],
    [1, 0, 1],
    [2, 0, 1],
  ]);
  expect(found.single).toEqual(['b', 'c']);
  expect(found.errors).toContainEqual({ clip: 4, nearest: 3 });
  comparer.destroy();
});

test('what is asked of a comparison that another has followed fails, and the worker goes on', async () => {
  const { comparer, workers } = setUp();
  await withPlaces(comparer, [0, 1, 5]).compare(average);
  comparer.setFeature(1, 'clip 1', null);
  const { tree } = await comparer.compare(average);
  const again = { failure: { kind: 'compared-again' } };
  await expect(comparer.explain(0, 1)).rejects.toMatchObject(again);
  const labels = ['a', 'a', 'b'];
  await expect(comparer.evaluate({ clusters: 2, labels })).rejects.toMatchObject(again);
  const all = { firstRow: 0, rowCount: 3, firstColumn: 0, columnCount: 3, most: 3 };
  const region = { ...all, order: Int32Array.of(0, 1, 2) };
  await expect(comparer.picture(region)).rejects.toMatchObject(again);
  expect((await comparer.explain(0, 2)).distance).toBe(5);
  expect(tree.leaves).toHaveLength(2);
  expect(workers).toHaveLength(1);
  comparer.destroy();
});

test('files come in parts and are whole', async () => {
  const { comparer } = setUp();
  const count = 400;
  const places = Array.from({ length: count }, (_, index) => Math.sin(index));
  await withPlaces(comparer, places).compare(ward);
  const labelled = { clusters: 2, labels: places.map((_, id) => (id % 3 ? 'a' : null)) };
  const table = await (await comparer.exportFile('matrix-csv', labelled)).text();
  const rows = table.trimEnd().split('\r\n');
  expect(rows).toHaveLength(count + 1);
  expect(table.length).toBeGreaterThan(2 ** 21);
  const cells = rows.slice(1).map((row) => row.split(','));
  expect(cells.every((row) => row.length === count + 1)).toBe(true);
  expect(Number(cells[3]?.[8])).toBeCloseTo(Math.abs(Math.sin(3) - Math.sin(7)), 15);
  const array = await (await comparer.exportFile('matrix-npy', labelled)).arrayBuffer();
  expect(array.byteLength).toBe(128 + 8 * count ** 2);
  const scores = await (await comparer.exportFile('evaluation-csv', labelled)).text();
  expect(scores.trimEnd().split('\r\n')).toHaveLength(count + 1);
  comparer.destroy();
});

test('what takes long can be cancelled', async () => {
  const { comparer, workers } = setUp();
  const places = Array.from({ length: 900 }, (_, index) => Math.sin(index));
  await withPlaces(comparer, places).compare(ward);
  const labelled = { clusters: 2, labels: places.map(() => null) };
  const cancelling = new AbortController();
  let parts = 0;
  const onProgress = (): void => {
    parts += 1;
    cancelling.abort();
  };
  const file = comparer.exportFile('matrix-csv', labelled, {
    signal: cancelling.signal,
    onProgress,
  });
  await expect(file).rejects.toMatchObject({ name: 'AbortError' });
  expect(parts).toBeGreaterThan(0);
  expect((await comparer.explain(0, 1)).distance).toBeGreaterThan(0);
  expect(workers).toHaveLength(1);
  comparer.destroy();
});

test('a file goes on with the comparison with which it began', async () => {
  const { comparer } = setUp();
  await withPlaces(comparer, [0, 1, 5]).compare(average);
  const labelled = { clusters: 1, labels: [null, null, null] };
  const file = comparer.exportFile('matrix-csv', labelled);
  comparer.setFeature(1, 'clip 1', null);
  await comparer.compare(average);
  expect((await (await file).text()).trimEnd().split('\r\n')).toHaveLength(4);
  comparer.destroy();
});

test('why two clips differ is told with their names and shares', async () => {
  const { comparer } = setUp();
  await withPlaces(comparer, [0, 3, 4]).compare(ward);
  const found = await comparer.explain(0, 2);
  expect(found).toMatchObject({ a: 0, b: 2, distance: 4, rank: 3, rankFromA: 2, rankFromB: 2 });
  expect(found.shares[0]).toBe(1);
  expect(found.sentence).toMatchObject({
    kind: 'component',
    component: 0,
    of: 'mean',
    larger: 'b',
  });
  comparer.destroy();
});

test('a worker that dies is replaced, and numbers its clips as before', async () => {
  const { comparer, deaths, workers } = setUp();
  withPlaces(comparer, [5, 1]);
  comparer.setFeature(9, 'clip 9', at(3));
  await comparer.compare(average);
  comparer.setFeature(4, 'clip 4', at(100));
  deaths[0]?.('gone');
  expect(await comparer.neighbours(9, 5)).toHaveLength(2);
  expect(workers).toHaveLength(2);
  const again = await comparer.compare(average);
  expect([...again.clips].sort((a, b) => a - b)).toEqual([0, 1, 4, 9]);
  comparer.destroy();
});

test('a comparison whose worker dies tells so, names no file, and the next one begins anew', async () => {
  const { comparer, deaths, workers } = setUp();
  const many = Array.from({ length: 900 }, (_, index) => Math.sin(index));
  withPlaces(comparer, many);
  const stopped = expect(comparer.compare(average)).rejects.toThrow(/^: comparison-stopped gone$/);
  while (workers.length === 0) await new Promise((next) => setTimeout(next));
  deaths[0]?.('gone');
  await stopped;
  expect((await comparer.compare(ward)).clips).toHaveLength(900);
  comparer.destroy();
});

test('comparisons and arrivals asked for at once come to an end', async () => {
  const { comparer, deaths } = setUp();
  withPlaces(
    comparer,
    Array.from({ length: 400 }, (_, index) => Math.sin(index)),
  );
  await comparer.compare(ward);
  for (let clip = 400; clip < 700; clip += 1) comparer.setFeature(clip, 'more', at(clip));
  deaths[0]?.('gone');
  const older = comparer.compare(ward).catch(() => null);
  const [arrivals, newer] = await Promise.all([comparer.arrivals(), comparer.compare(ward)]);
  await older;
  expect(newer.clips).toHaveLength(700);
  expect(arrivals.clips.length).toBeLessThanOrEqual(300);
  comparer.destroy();
});
