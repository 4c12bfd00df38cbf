import { signal } from '@preact/signals-core';
import { expect, test, vi } from 'vitest';
import type { Context } from '../app/context';
import { createStore } from '../app/store';
import '../app/i18n/test-words';
import { wordsFor } from '../app/i18n/catalogue';
import { saveBlob } from '../common/save-file';
import type { Comparer, Comparison, Cut } from '../engine/comparison-types';
import { createSetFiles } from './set-files';

vi.mock('../common/save-file', () => ({ saveBlob: vi.fn() }));

/** A set of two clips; its files are finished, or fail, by hand. */
function setUp() {
  const store = createStore();
  store.compare.comparison.value = { clips: Int32Array.of(0, 1) } as unknown as Comparison;
  store.compare.cut.value = { clusters: 1 } as Cut;
  const asked: { work: Parameters<Comparer['exportFile']>[2]; end: (blob: Blob) => void }[] = [];
  const exportFile: Comparer['exportFile'] = (_kind, _labelled, work) =>
    new Promise((resolve, reject) => {
      asked.push({ work, end: resolve });
      work?.signal?.addEventListener('abort', () => reject(new DOMException('', 'AbortError')));
    });
  const language = { words: signal(wordsFor('en')) };
  const context = { store, comparer: { exportFile }, language } as unknown as Context;
  vi.mocked(saveBlob).mockClear();
  return { files: createSetFiles(context), asked, store };
}

test('a file tells how far it is, and is saved under its name', async () => {
  const { files, asked, store } = setUp();
  const saved = files.save('matrix-csv');
  asked[0].work?.onProgress?.({ stage: 'analysing', done: 0.25 });
  expect(files.underWay.value).toMatchObject({ fileName: 'distances.csv', done: 0.25 });
  const blob = new Blob(['1']);
  asked[0].end(blob);
  await saved;
  expect(saveBlob).toHaveBeenCalledWith('distances.csv', blob);
  expect(files.underWay.value).toBeNull();
  expect(store.toast.value?.kind).toBe('done');
});

test('one file at a time', () => {
  const { files, asked } = setUp();
  void files.save('matrix-csv');
  void files.save('matrix-npy');
  expect(asked).toHaveLength(1);
});

test('a file that is cancelled is not saved, says nothing, and leaves the next one alone', async () => {
  const { files, asked, store } = setUp();
  const saved = files.save('matrix-csv');
  files.cancel();
  expect(files.underWay.value).toBeNull();
  void files.save('matrix-npy');
  await saved;
  asked[0].work?.onProgress?.({ stage: 'analysing', done: 0.5 });
  expect(files.underWay.value).toMatchObject({ fileName: 'distances.npy', done: 0 });
  expect(saveBlob).not.toHaveBeenCalled();
  expect(store.toast.value).toBeNull();
});
