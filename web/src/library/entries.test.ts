import { expect, test } from 'vitest';
import { testClip } from '../app/test-clips';
import { clipsBetween, heightOf, libraryLayout, placeOfClip, placeOfGroup } from './entries';

const clips = [0, 1, 2, 3].map((id) => testClip(id, `m${id}.bvh`));
const labels = new Map([
  [0, 'walk'],
  [1, 'walk'],
  [2, 'run'],
  [3, null],
]);
const sources = { rows: clips, labels, grouped: true, folded: new Set<string | null>() };

test('clips of one label stand under a head that counts them', () => {
  const { entries, tops } = libraryLayout(sources);
  expect(entries.map((entry) => (entry.kind === 'group' ? entry.label : entry.clip.id))).toEqual([
    'walk',
    0,
    1,
    'run',
    2,
    null,
    3,
  ]);
  expect(entries[0]).toMatchObject({ count: 2, folded: false });
  expect([...tops]).toEqual([0, 28, 72, 116, 144, 188, 216, 260]);
});

test('a folded group is its head alone; places of clips stay those of all', () => {
  const layout = libraryLayout({ ...sources, folded: new Set(['walk', null]) });
  expect(layout.entries).toHaveLength(4);
  expect(heightOf(layout)).toBe(3 * 28 + 44);
  expect(layout.entries[2]).toMatchObject({ kind: 'clip', index: 2 });
  expect(placeOfClip(layout, 0)).toBe(-1);
  expect(placeOfGroup(layout, null)).toBe(3);
});

test('without groups there are no heads', () => {
  const layout = libraryLayout({ ...sources, grouped: false });
  expect(layout.entries.every(({ kind }) => kind === 'clip')).toBe(true);
  expect(heightOf(layout)).toBe(4 * 44);
});

test('a range has the clips between two rows, whichever comes first, and no heads', () => {
  const layout = libraryLayout(sources);
  expect(clipsBetween(layout, 4, 1)).toEqual([0, 1, 2]);
  expect(clipsBetween(layout, 6, 6)).toEqual([3]);
});
