import { effect } from '@preact/signals-core';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { addClips, clipNow, patchClip, patchClipSoon } from './clip-changes';
import { createStore } from './store';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

function setUp(clips: number) {
  const store = createStore();
  addClips(
    store,
    Array.from({ length: clips }, (_, id) => ({ name: `${id}`, folder: '', blob: new Blob() })),
  );
  let lists = 0;
  effect(() => {
    void store.clips.value;
    lists += 1;
  });
  return { store, lists: () => lists };
}

test('changes that can wait make one list together', async () => {
  const { store, lists } = setUp(100);
  for (let id = 0; id < 100; id += 1) patchClipSoon(store, id, { progress: 1 });
  expect(store.clips.value[7]?.progress).toBe(0);
  expect(clipNow(store, 7)?.progress).toBe(1);
  await vi.advanceTimersByTimeAsync(300);
  expect(store.clips.value.every(({ progress }) => progress === 1)).toBe(true);
  expect(lists()).toBe(2);
});

test('a change that cannot wait comes after those that waited', async () => {
  const { store } = setUp(1);
  patchClipSoon(store, 0, { outdated: false, status: 'ready' });
  patchClip(store, 0, { outdated: true });
  await vi.advanceTimersByTimeAsync(300);
  expect(store.clips.value[0]).toMatchObject({ outdated: true, status: 'ready' });
});
