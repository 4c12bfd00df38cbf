import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { createBacklog } from './backlog';
import { addClips, flushClips, patchClip } from './clip-changes';
import { createStore } from './store';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

function setUp(clips: number) {
  const store = createStore();
  const added = addClips(
    store,
    Array.from({ length: clips }, (_, id) => ({ name: `${id}`, folder: '', blob: new Blob() })),
  );
  for (const { id } of added) patchClip(store, id, { status: 'surveyed' });
  const opened: number[] = [];
  const analysis = {
    open: (id: number, signal: AbortSignal) =>
      new Promise<void>((resolve, reject) => {
        opened.push(id);
        signal.addEventListener('abort', () => reject(new DOMException('', 'AbortError')));
        setTimeout(() => {
          if (!signal.aborted) patchClip(store, id, { status: 'ready' });
          resolve();
        }, 100);
      }),
  };
  const backlog = createBacklog({ store, analysis, now: () => Date.now() });
  return { store, opened, backlog, ids: added.map(({ id }) => id) };
}

test('all clips follow, some at a time, and how far it is is told', async () => {
  const { store, opened, backlog, ids } = setUp(60);
  backlog.add(ids);
  await vi.advanceTimersByTimeAsync(260);
  expect(opened.length).toBeLessThan(60);
  expect(store.loading.value).toMatchObject({ stage: 'keyposes', total: 60 });
  await vi.advanceTimersByTimeAsync(5000);
  expect(opened).toHaveLength(60);
  expect(store.clips.value.every(({ status }) => status === 'ready')).toBe(true);
  expect(store.loading.value).toBeNull();
});

test('the clip that is opened goes first, also while the rest is held', () => {
  const { store, opened, backlog, ids } = setUp(60);
  backlog.hold(true);
  backlog.add(ids);
  expect(opened).toEqual([]);
  store.openId.value = 55;
  expect(opened).toEqual([55]);
  store.compare.otherId.value = 41;
  expect(opened).toEqual([55, 41]);
  backlog.hold(false);
  expect(opened[2]).toBe(0);
});

test('a cancel leaves the rest for when it is opened', async () => {
  const { store, opened, backlog, ids } = setUp(60);
  backlog.add(ids);
  backlog.cancel();
  await vi.advanceTimersByTimeAsync(1000);
  flushClips(store);
  const begun = opened.length;
  expect(store.clips.value.every(({ status }) => status === 'surveyed')).toBe(true);
  expect(store.loading.value).toBeNull();
  store.openId.value = 50;
  await vi.advanceTimersByTimeAsync(1000);
  expect(opened.length).toBe(begun + 1);
  expect(store.clips.value[50]?.status).toBe('ready');
});
