import { expect, test } from 'vitest';
import { EngineError, type Engine } from '../engine/types';
import { createLoader, type BatchReport } from './loading';
import { patchClip } from './clip-changes';
import { createStore } from './store';

function setUp(
  open: (id: number, signal: AbortSignal) => Promise<void> = () => Promise.resolve(),
  unzip: Engine['unzip'] = () => Promise.reject(new Error('no')),
  survey: Engine['survey'] = () => Promise.reject(new Error('no')),
) {
  const store = createStore();
  const reports: BatchReport[] = [];
  const loader = createLoader({
    engine: { unzip, survey },
    store,
    analysis: {
      open: async (id, signal) => {
        await open(id, signal);
        patchClip(store, id, { status: 'ready' });
      },
    },
    backlog: {
      // It begins at once with the first of them.
      add: (ids) => ids.slice(0, 1).forEach((id) => patchClip(store, id, { status: 'analysing' })),
      hold: () => undefined,
      cancel: () => undefined,
    },
    now: () => 0,
    onStart: () => undefined,
    onSettled: () => undefined,
    onEnd: (report) => void reports.push(report),
  });
  return { store, loader, reports };
}

const file = (name: string, content = 'x') => new File([content], name, { lastModified: 1 });
const source = (name: string, folder = '') => ({ name, folder, blob: file(name) });

test('everything given becomes a clip and one report', async () => {
  const { store, loader, reports } = setUp();
  await Promise.all([loader.add([source('a.bvh')]), loader.add([source('b.bvh')])]);
  expect(store.present.value.map((clip) => clip.source.name)).toEqual(['a.bvh', 'b.bvh']);
  expect(reports.at(-1)?.failed).toEqual([]);
  expect(store.loading.value).toBeNull();
});

test('the same file twice is one clip, its namesake from another folder is another', async () => {
  const { store, loader, reports } = setUp();
  await loader.add([source('a.bvh'), source('a.bvh'), source('a.bvh', 'other')]);
  expect(store.present.value).toHaveLength(2);
  expect(reports[0]?.known).toEqual([0]);
});

test('a cancel takes out what has not been read and keeps what has', async () => {
  const waits = (signal: AbortSignal): Promise<void> =>
    new Promise((_, reject) => {
      signal.addEventListener('abort', () => reject(new DOMException('', 'AbortError')));
    });
  const { store, loader, reports } = setUp((id, signal) =>
    id === 0 ? Promise.resolve() : waits(signal),
  );
  const done = loader.add([source('a.bvh'), source('b.bvh')]);
  await Promise.resolve();
  loader.cancel();
  await done;
  expect(reports[0]?.cancelled).toBe(true);
  expect(store.present.value.map((clip) => clip.source.name)).toEqual(['a.bvh']);
});

test('what is given right after a cancel is read, also what the cancel took out', async () => {
  const { store, loader, reports } = setUp((id, signal) =>
    id > 0
      ? Promise.resolve()
      : new Promise((_, reject) => {
          signal.addEventListener('abort', () => reject(new DOMException('', 'AbortError')));
        }),
  );
  const cancelled = loader.add([source('a.bvh')]);
  await Promise.resolve();
  loader.cancel();
  const again = loader.add([source('a.bvh'), source('b.bvh')]);
  await Promise.all([cancelled, again]);
  expect(store.present.value.map((clip) => clip.source.name)).toEqual(['a.bvh', 'b.bvh']);
  expect(reports.map((report) => report.cancelled).sort()).toEqual([false, true]);
  expect(store.loading.value).toBeNull();
});

test('what is no motion is told, what is a bad archive too', async () => {
  const { loader, reports } = setUp();
  await loader.take([
    { file: file('notes.txt'), folder: '' },
    { file: file('set.zip'), folder: '' },
  ]);
  expect(reports[0]?.others).toEqual(['notes.txt']);
  expect(reports[0]?.archives[0]?.failure.kind).toBe('internal');
});

test('an entry that cannot be unpacked is a row with its name and its folder', async () => {
  const failure = { kind: 'archive-entry-encrypted', line: null, column: null, details: [] };
  const { store, loader } = setUp(undefined, (_archive, _onEntry, work) => {
    work?.onFailure?.(new EngineError(failure, 'set/dances/a.bvh'));
    return Promise.resolve();
  });
  await loader.take([{ file: file('set.zip'), folder: '' }]);
  expect(store.present.value[0]?.source).toMatchObject({ name: 'a.bvh', folder: 'set/dances' });
  expect(store.present.value[0]?.status).toBe('failed');
});

test('of many files the first is analysed and the others are surveyed, each with its outcome', async () => {
  const opened: number[] = [];
  const failure = { kind: 'empty', line: null, column: null, details: [] };
  const { store, loader, reports } = setUp(
    (id) => {
      opened.push(id);
      return Promise.resolve();
    },
    undefined,
    (items, onSurveyed) => {
      const read = { frames: 9, frameTimeS: 0.1, feature: null, incomparable: failure };
      onSurveyed(items.map(({ id }) => ({ id, ...read, failure: id === 7 ? failure : null })));
      return Promise.resolve();
    },
  );
  await loader.add(Array.from({ length: 200 }, (_, index) => source(`${index}.bvh`)));
  expect(opened).toEqual([0]);
  const statuses = store.clips.value.map(({ status }) => status);
  expect(statuses.filter((status) => status === 'surveyed')).toHaveLength(197);
  expect(store.clips.value[7]).toMatchObject({ status: 'failed', failure });
  expect(store.clips.value[8]).toMatchObject({ extent: { frames: 9 }, incomparable: failure });
  expect(reports[0]).toMatchObject({ failed: [7], cancelled: false });
  expect(reports[0]?.clips).toHaveLength(200);
  expect(store.reading.value).toBe(false);
});

test('a survey that is cancelled keeps what it has read', async () => {
  let surveyed: (id: number) => void = () => undefined;
  const { store, loader, reports } = setUp(undefined, undefined, (items, onSurveyed, work) => {
    surveyed = (id) => {
      const read = { frames: 9, frameTimeS: 0.1, feature: null, incomparable: null };
      onSurveyed([{ id, failure: null, ...read }]);
    };
    expect(items.length).toBe(99);
    return new Promise((_, reject) => {
      work?.signal?.addEventListener('abort', () => reject(new DOMException('', 'AbortError')));
    });
  });
  const done = loader.add(Array.from({ length: 100 }, (_, index) => source(`${index}.bvh`)));
  await Promise.resolve();
  surveyed(40);
  loader.cancel();
  surveyed(41);
  await done;
  expect(store.present.value.map(({ id }) => id)).toEqual([0, 40]);
  expect(reports[0]?.cancelled).toBe(true);
});
