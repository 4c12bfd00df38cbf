import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { ClipResult, Engine, MethodOptions } from '../engine/types';
import { createAnalysis, settleMs } from './analysis';
import { addClips } from './clip-changes';
import { createStore } from './store';
import { testResult } from './test-clips';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

function setUp() {
  const store = createStore();
  const opened: ((result: ClipResult) => void)[] = [];
  const analysed: MethodOptions[] = [];
  const engine = {
    open: () => new Promise<ClipResult>((resolve) => opened.push(resolve)),
    analyse: (_id: number, _decisions: unknown, options: MethodOptions) => {
      analysed.push(options);
      return Promise.resolve(testResult(10, analysed.length));
    },
  } as unknown as Engine;
  const analysis = createAnalysis(engine, store, () => undefined);
  const source = { name: 'a.bvh', folder: '', blob: new Blob(['x']) };
  const [{ id }] = addClips(store, [source]);
  store.openId.value = id;
  const opening = analysis.open(id, new AbortController().signal);
  return { store, opened, analysed, analysis, opening };
}

test('a clip that was read while a parameter changed is analysed again', async () => {
  const { store, opened, analysed, analysis, opening } = setUp();
  analysis.setOptions({ lowPassHz: 6 });
  opened[0]?.(testResult(10, 0));
  await opening;
  expect(store.clips.value[0]).toMatchObject({ status: 'ready', outdated: true });
  await vi.advanceTimersByTimeAsync(settleMs);
  expect(analysed).toEqual([{ lowPassHz: 6 }]);
  expect(store.clips.value[0]).toMatchObject({ outdated: false });
});

test('a clip that was read with the parameters of now is not', async () => {
  const { opened, analysed, opening } = setUp();
  opened[0]?.(testResult(10, 0));
  await opening;
  await vi.advanceTimersByTimeAsync(settleMs);
  expect(analysed).toEqual([]);
});
