import { expect, test } from 'vitest';
import { createOpener } from './opening';
import { addClips, patchClip } from './clip-changes';
import { createStore } from './store';

function setUp(names: readonly string[]) {
  const store = createStore();
  addClips(
    store,
    names.map((name) => ({ name, folder: '', blob: new Blob(['x']) })),
  );
  const opener = createOpener(store, (id) => {
    store.openId.value = id;
  });
  return { store, opener };
}

test('the first file opens by itself, and one that was given alone when it has been read', () => {
  const { store, opener } = setUp(['a.bvh', 'b.bvh']);
  opener.started(0);
  expect(store.openId.value).toBe(0);
  opener.started(1);
  expect(store.openId.value).toBe(0);
  opener.settled(1, 1);
  expect(store.openId.value).toBe(1);
});

test('a file that was removed while it was read does not open', () => {
  const { store, opener } = setUp(['a.bvh', 'b.bvh']);
  opener.started(0);
  patchClip(store, 1, { removed: true });
  opener.settled(1, 1);
  expect(store.openId.value).toBe(0);
});

test('beside others that are compared, a file given alone leaves the chosen ones as they are', () => {
  const { store, opener } = setUp(['a.bvh', 'b.bvh']);
  opener.started(0);
  store.compare.page.value = 'pair';
  opener.started(1);
  opener.settled(1, 1);
  expect(store.openId.value).toBe(0);
});
