import { expect, test } from 'vitest';
import { testClip, testResult } from '../app/test-clips';
import type { Comparison, Cut } from '../engine/comparison-types';
import { clipFacts, stepTo, tableRows, type RowSettings, type TableRow } from './table-rows';

const failure = { kind: 'empty', line: null, column: null, details: [] };
const clips = [
  testClip(0, 'b2.bvh', { result: testResult(201, 4) }),
  testClip(1, 'b10.bvh', { result: testResult(101, 2) }),
  testClip(3, 'a.bvh', { result: testResult(301, 3) }),
  testClip(4, 'broken.bvh', { status: 'failed', failure }),
  testClip(5, 'chair.bvh', { result: testResult(11, 0), incomparable: failure }),
];
const labels = new Map([
  [0, 'walk'],
  [1, 'run'],
  [3, null],
  [4, 'walk'],
  [5, null],
]);
const qualifiers = new Map<number, string>();
const comparison = {
  clips: Int32Array.from([0, 1, 3]),
  nearest: Int32Array.from([2, 0, 0]),
  nearestDistances: Float64Array.from([0.1, 0.5, 0.1]),
} as Comparison;
const cut: Cut = { clusters: 2, clusterOfItem: Int32Array.from([0, 1, 0]), height: 0.3 };
const facts = clipFacts({ clips, qualifiers, labels, comparison, cut });

const settings: RowSettings = {
  sort: { column: 'name', descending: false },
  filter: '',
  grouped: false,
  labelNames: ['walk', 'run'],
};
const said = (rows: readonly TableRow[]): (string | number)[] =>
  rows.map((row) => (row.kind === 'clip' ? row.facts.clip.id : `${row.label} ${row.count}`));

test('a clip knows its cluster from 1, what is nearest, and how far', () => {
  expect(facts[1]).toMatchObject({
    length: 1,
    rate: 100,
    keyposes: 2,
    cluster: 2,
    nearest: 'b2.bvh',
    nearestId: 0,
    distance: 0.5,
  });
});

test('a namesake is named with what tells it apart', () => {
  const namesakes = new Map([[0, 'left']]);
  const named = clipFacts({ clips, qualifiers: namesakes, labels, comparison, cut });
  expect([named[0].name, named[1].nearest]).toEqual(['left b2.bvh', 'left b2.bvh']);
});

test('clips that are not compared stand as rows without those figures', () => {
  expect(facts[3]).toMatchObject({ apart: true, length: null, cluster: null, distance: null });
  expect(facts[4]).toMatchObject({ apart: true, length: 0.1, nearest: null });
});

test('sorted by every kind of column, what is not known last either way', () => {
  const by = (sort: RowSettings['sort']) => said(tableRows(facts, { ...settings, sort }));
  expect(by({ column: 'name', descending: false })).toEqual([3, 0, 1, 4, 5]);
  expect(by({ column: 'distance', descending: true })).toEqual([1, 0, 3, 4, 5]);
  expect(by({ column: 'length', descending: false })).toEqual([5, 1, 0, 3, 4]);
  expect(by({ column: 'label', descending: true })).toEqual([0, 4, 1, 3, 5]);
});

test('filtered by name and by label', () => {
  expect(said(tableRows(facts, { ...settings, filter: 'walk' }))).toEqual([0, 4]);
  expect(said(tableRows(facts, { ...settings, filter: 'b1' }))).toEqual([1]);
});

test('grouped by label; those without, and those apart, last', () => {
  expect(said(tableRows(facts, { ...settings, grouped: true }))).toEqual([
    'walk 1',
    0,
    'run 1',
    1,
    'null 1',
    3,
    'null 2',
    4,
    5,
  ]);
});

test('a cut of an older comparison is not shown', () => {
  const older = { ...cut, clusterOfItem: Int32Array.from([0]) };
  expect(clipFacts({ clips, qualifiers, labels, comparison, cut: older })[0].cluster).toBe(null);
});

test('keys go from clip to clip over the heads of groups', () => {
  const rows = tableRows(facts, { ...settings, grouped: true });
  expect(stepTo(rows, 0, 'ArrowDown')).toBe(3);
  expect(stepTo(rows, 0, 'ArrowUp')).toBe(1);
  expect(stepTo(rows, 0, 'End')).toBe(8);
  expect(stepTo(rows, null, 'ArrowDown')).toBe(1);
  expect(stepTo(rows, 0, 'x')).toBe(null);
  expect(stepTo([], 0, 'Home')).toBe(null);
});
