import { expect, test } from 'vitest';
import { labelLook, labelNames, labelsOf, labelStyle, steadyLabels, withRename } from './labels';
import { testClip } from './test-clips';

const clips = [
  testClip(0, '05_01.bvh', {}, 'set/dance'),
  testClip(2, '07_01.bvh', {}, 'set/walk'),
  testClip(3, 'walk.bvh'),
];
const nothing = new Map<number, string>();
const pattern = { kind: 'pattern', pattern: '{label}_*' } as const;

test('by folder: the folder that the file lies in', () => {
  const labels = labelsOf({ kind: 'folder' }, nothing, clips);
  expect([...labels]).toEqual([
    [0, 'dance'],
    [2, 'walk'],
    [3, null],
  ]);
});

test('by file name', () => {
  expect([...labelsOf(pattern, nothing, clips).values()]).toEqual(['05', '07', null]);
});

test('none, and a pattern with a fault, label nothing', () => {
  const faulty = { kind: 'pattern', pattern: '*' } as const;
  expect([...labelsOf({ kind: 'none' }, nothing, clips).values()]).toEqual([null, null, null]);
  expect([...labelsOf(faulty, nothing, clips).values()]).toEqual([null, null, null]);
});

test('by hand comes before, and an empty one takes the label away', () => {
  const hand = new Map([
    [0, ''],
    [3, 'walk'],
  ]);
  expect([...labelsOf(pattern, hand, clips).values()]).toEqual([null, '07', 'walk']);
});

test('names in the order of their first clip', () => {
  const labels = new Map([
    [0, null],
    [1, 'b'],
    [2, 'a'],
    [3, 'b'],
  ]);
  expect(labelNames(labels)).toEqual(['b', 'a']);
});

test('beyond six, colours repeat with open shapes', () => {
  expect(labelStyle(0)).toEqual({ colour: '--label-0', shape: 'circle', open: false });
  expect(labelStyle(5)).toEqual({ colour: '--label-5', shape: 'plus', open: false });
  expect(labelStyle(7)).toEqual({ colour: '--label-1', shape: 'square', open: true });
  expect(labelStyle(12).open).toBe(false);
});

test('the same labels are the same map', () => {
  const before = labelsOf(pattern, nothing, clips);
  expect(steadyLabels(before, labelsOf(pattern, nothing, clips))).toBe(before);
  const other = labelsOf({ kind: 'folder' }, nothing, clips);
  expect(steadyLabels(before, other)).toBe(other);
});

test('a label that a rule gives has another name; one given by hand has not', () => {
  const renames = withRename(new Map(), '05', 'dance');
  const hand = new Map([[2, '05']]);
  expect([...labelsOf(pattern, hand, clips, renames).values()]).toEqual(['dance', '05', null]);
});

test('renamed again, the name of before goes along; two names may become one', () => {
  const twice = withRename(withRename(new Map(), '05', 'dance'), 'dance', 'waltz');
  expect([...labelsOf(pattern, new Map(), clips, twice).values()]).toEqual(['waltz', '07', null]);
  const joined = withRename(twice, '07', 'waltz');
  expect([...labelsOf(pattern, new Map(), clips, joined).values()]).toEqual([
    'waltz',
    'waltz',
    null,
  ]);
});

test('thousands of labels have a dozen looks', () => {
  const looks = new Set<number>();
  for (let index = 0; index < 3000; index++) {
    expect(labelStyle(labelLook(index))).toEqual(labelStyle(index));
    looks.add(labelLook(index));
  }
  expect(looks.size).toBe(12);
  expect(labelLook(-1)).toBe(-1);
});
