import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type {
  ClipFeature,
  Comparer,
  Comparison,
  ComparisonSettings,
} from '../engine/comparison-types';
import { addClips, patchClip } from './clip-changes';
import { usualSettings } from './compare-store';
import { followComparison } from './comparing';
import { createStore, type Store } from './store';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

function featureAt(place: number): ClipFeature {
  return {
    performer: 0,
    recorded: Float64Array.of(place),
    acrossRigs: new Float64Array(),
    recordedByJoint: new Float64Array(),
    acrossRigsByJoint: new Float64Array(),
  };
}

/** A comparer that notes what it is told and takes `costMs` to compare. */
function fakeComparer(costMs = 0) {
  const features = new Map<number, ClipFeature>();
  const compared: { settings: ComparisonSettings; clips: number[]; keepsPlaces: boolean }[] = [];
  let covered: number[] = [];
  const comparison = (settings: ComparisonSettings, clips: number[]): Comparison =>
    ({ settings, clips: Int32Array.from(clips), automaticClusters: 2 }) as unknown as Comparison;
  const comparer: Partial<Comparer> = {
    setFeature(clip, _name, feature) {
      if (feature) features.set(clip, feature);
      else features.delete(clip);
    },
    async compare(settings, { keepsPlaces = false } = {}) {
      const clips = [...features.keys()];
      compared.push({ settings, clips, keepsPlaces });
      await new Promise((resolve) => setTimeout(resolve, costMs));
      covered = clips;
      return comparison(settings, clips);
    },
    arrivals() {
      const clips = [...features.keys()].filter((clip) => !covered.includes(clip));
      const places = Float64Array.from(clips.flatMap((clip) => [clip, -clip]));
      return Promise.resolve({ clips: Int32Array.from(clips), places });
    },
    cut: (clusters) =>
      Promise.resolve({ clusters, clusterOfItem: Int32Array.of(0, 1), height: clusters }),
    neighbours: (clip) => Promise.resolve([{ clip: clip + 1, distance: 1, mirrored: false }]),
    explain: (a, b) => Promise.resolve({ a, b } as never),
    evaluate: ({ labels }) => Promise.resolve({ labelled: labels.length } as never),
  };
  return { comparer: comparer as Comparer, compared, features };
}

function setUp(clips: number, costMs = 0) {
  const store = createStore();
  const sources = Array.from({ length: clips }, (_, index) => ({
    name: `${'ab'[index % 2]}_${index}.bvh`,
    folder: '',
    blob: new Blob(['x']),
  }));
  addClips(store, sources);
  const fake = fakeComparer(costMs);
  const errors: unknown[] = [];
  const end = followComparison({
    store,
    comparer: fake.comparer,
    now: () => Date.now(),
    tellError: (error) => errors.push(error),
  });
  return { store, ...fake, errors, end };
}

const know = (store: Store, id: number, place = id): void =>
  patchClip(store, id, { feature: featureAt(place) });

test('one clip is no set; the second starts the comparison', async () => {
  const { store, compared } = setUp(2);
  know(store, 0);
  await vi.advanceTimersByTimeAsync(1000);
  expect(compared).toHaveLength(0);
  know(store, 1);
  await vi.advanceTimersByTimeAsync(1000);
  expect(compared.map(({ clips }) => clips)).toEqual([[0, 1]]);
  expect(store.compare.comparison.value?.clips).toEqual(Int32Array.of(0, 1));
  expect(store.compare.cut.value?.clusters).toBe(2);
  expect(store.compare.comparing.value).toBeNull();
});

test('nothing is compared before the open clip is shown, except on the page itself', async () => {
  const { store, compared } = setUp(3);
  store.openId.value = 2;
  know(store, 0);
  know(store, 1);
  await vi.advanceTimersByTimeAsync(1000);
  expect(compared).toHaveLength(0);
  store.compare.page.value = 'compare';
  await vi.advanceTimersByTimeAsync(1000);
  expect(compared).toHaveLength(1);
});

test('while files are read it is made again as the set grows, and once more at the end', async () => {
  const { store, compared } = setUp(40, 100);
  store.reading.value = true;
  for (let id = 0; id < 40; id += 1) {
    know(store, id);
    await vi.advanceTimersByTimeAsync(50);
  }
  expect(compared.length).toBeGreaterThan(1);
  expect(compared.length).toBeLessThan(8);
  expect(store.compare.comparison.value).not.toBeNull();
  store.reading.value = false;
  await vi.advanceTimersByTimeAsync(1000);
  expect(store.compare.comparison.value?.clips).toHaveLength(40);
});

test('what comes between two comparisons is on the map within 100 ms', async () => {
  const { store, compared } = setUp(40);
  const { arrivals } = store.compare;
  store.reading.value = true;
  for (let id = 0; id < 30; id += 1) know(store, id);
  await vi.advanceTimersByTimeAsync(1000);
  know(store, 30);
  await vi.advanceTimersByTimeAsync(100);
  expect(compared).toHaveLength(1);
  expect([...arrivals.value]).toEqual([[30, [30, -30]]]);
  patchClip(store, 30, { removed: true });
  expect(arrivals.value.size).toBe(0);
});

test('a clip that is taken out while its place is asked for does not arrive', async () => {
  const { store, comparer } = setUp(40);
  let answer = (): void => undefined;
  const found = { clips: Int32Array.of(30, 31), places: Float64Array.of(1, 2, 3, 4) };
  comparer.arrivals = () => new Promise((resolve) => (answer = () => resolve(found)));
  store.reading.value = true;
  for (let id = 0; id < 30; id += 1) know(store, id);
  await vi.advanceTimersByTimeAsync(1000);
  know(store, 30);
  know(store, 31);
  await vi.advanceTimersByTimeAsync(50);
  patchClip(store, 30, { removed: true });
  answer();
  await vi.advanceTimersByTimeAsync(0);
  expect([...store.compare.arrivals.value.keys()]).toEqual([31]);
});

test('labels of clips that only come are not evaluated', async () => {
  const { store, comparer } = setUp(40);
  const evaluate = vi.spyOn(comparer, 'evaluate');
  store.reading.value = true;
  store.compare.labelRule.value = { kind: 'pattern', pattern: '{label}_*' };
  for (let id = 0; id < 30; id += 1) know(store, id);
  await vi.advanceTimersByTimeAsync(1000);
  expect(evaluate).toHaveBeenCalledTimes(1);
  addClips(store, [{ name: 'c_new.bvh', folder: '', blob: new Blob(['x']) }]);
  await vi.advanceTimersByTimeAsync(100);
  expect(evaluate).toHaveBeenCalledTimes(1);
  store.compare.handLabels.value = new Map([[3, 'c']]);
  await vi.advanceTimersByTimeAsync(100);
  expect(evaluate).toHaveBeenCalledTimes(2);
});

test('while files are read clips keep their places; the end lays all out', async () => {
  const { store, compared } = setUp(40, 20);
  store.reading.value = true;
  for (let id = 0; id < 40; id += 1) {
    know(store, id);
    await vi.advanceTimersByTimeAsync(50);
  }
  await vi.advanceTimersByTimeAsync(1000);
  const first = compared.findIndex(({ keepsPlaces }) => keepsPlaces);
  expect(first).toBeGreaterThan(1);
  expect(compared[first - 1].clips.length).toBeGreaterThanOrEqual(16);
  expect(compared[first - 2].clips.length).toBeLessThan(16);
  expect(compared.slice(first).every(({ keepsPlaces }) => keepsPlaces)).toBe(true);
  store.reading.value = false;
  await vi.advanceTimersByTimeAsync(1000);
  expect(compared.at(-1)).toMatchObject({ keepsPlaces: false });
  expect(compared.at(-1)?.clips).toHaveLength(40);
});

test('all is laid out in the end also where nothing has come since', async () => {
  const { store, compared } = setUp(45);
  store.reading.value = true;
  for (let id = 0; id < 20; id += 1) know(store, id);
  await vi.advanceTimersByTimeAsync(1000);
  for (let id = 20; id < 45; id += 1) know(store, id);
  await vi.advanceTimersByTimeAsync(1000);
  expect(compared.map(({ keepsPlaces }) => keepsPlaces)).toEqual([false, true]);
  store.reading.value = false;
  await vi.advanceTimersByTimeAsync(1000);
  expect(compared.map(({ keepsPlaces }) => keepsPlaces)).toEqual([false, true, false]);
  expect(store.compare.arrivals.value.size).toBe(0);
});

test('a clip that is removed or decided about is compared anew, its undo too', async () => {
  const { store, compared, features } = setUp(3);
  [0, 1, 2].forEach((id) => know(store, id));
  await vi.advanceTimersByTimeAsync(1000);
  patchClip(store, 1, { removed: true });
  await vi.advanceTimersByTimeAsync(1000);
  expect(compared.at(-1)?.clips).toEqual([0, 2]);
  patchClip(store, 1, { removed: false });
  know(store, 0, 7);
  await vi.advanceTimersByTimeAsync(1000);
  expect(compared).toHaveLength(3);
  expect(features.get(0)?.recorded[0]).toBe(7);
  patchClip(store, 0, { removed: true });
  patchClip(store, 1, { removed: true });
  expect(store.compare.comparison.value).toBeNull();
});

test('other settings are compared at once', async () => {
  const { store, compared } = setUp(2);
  [0, 1].forEach((id) => know(store, id));
  await vi.advanceTimersByTimeAsync(1000);
  store.compare.settings.value = { ...usualSettings, linkage: 'average' };
  await vi.advanceTimersByTimeAsync(0);
  expect(compared.at(-1)?.settings.linkage).toBe('average');
});

test('cut, neighbours, explanation and evaluation follow what is set and selected', async () => {
  const { store } = setUp(4);
  const { compare } = store;
  [0, 1, 2, 3].forEach((id) => know(store, id));
  await vi.advanceTimersByTimeAsync(1000);
  compare.cutClusters.value = 3;
  store.openId.value = 0;
  compare.otherId.value = 2;
  compare.labelRule.value = { kind: 'pattern', pattern: '{label}_*' };
  await vi.advanceTimersByTimeAsync(0);
  expect(compare.cut.value?.clusters).toBe(3);
  expect(compare.neighbours.value[0]?.clip).toBe(1);
  expect(compare.explanation.value).toMatchObject({ a: 0, b: 2 });
  expect(compare.evaluation.value?.labelled).toBe(4);
  patchClip(store, 2, { removed: true });
  expect(compare.otherId.value).toBeNull();
  expect(compare.explanation.value).toBeNull();
  compare.labelRule.value = { kind: 'none' };
  expect(compare.evaluation.value).toBeNull();
});
