import { expect, test } from 'vitest';
import { groupNames } from './group-names';
import { matrixGeometry, noZoom } from './matrix-geometry';
import { testScene } from './test-scene';

const size = { width: 780, height: 590 };
/** A thousand rows: of label 0 to the middle, then some of label 1, then those without. */
const groups = Int32Array.from({ length: 1000 }, (_, k) => (k < 500 ? 0 : k < 900 ? 1 : -1));
const scene = { ...testScene({ kind: 'label' }), count: 1000, groups };

test('each label stands in the middle of its rows', () => {
  const geometry = matrixGeometry(scene, size, noZoom, 50);
  const names = groupNames(scene, geometry);
  expect(names.map(({ label }) => label)).toEqual([0, 1, -1]);
  const { axis } = geometry;
  expect(names[0].middlePx).toBeCloseTo((axis.start(499) + axis.cell) / 2);
});

test('zoomed in, in the middle of what is in sight of them; those out of sight have none', () => {
  const geometry = matrixGeometry(scene, size, { cell: 4, x: 0, y: 0 }, 50);
  expect(groupNames(scene, geometry)).toEqual([{ label: 0, middlePx: geometry.side / 2 }]);
});

test('names that would touch each other are left out, the first of them stands', () => {
  const many = { ...scene, groups: Int32Array.from({ length: 1000 }, (_, k) => k >> 2) };
  const names = groupNames(many, matrixGeometry(many, size, noZoom, 50));
  expect(names[0].label).toBe(0);
  for (let k = 1; k < names.length; k += 1)
    expect(names[k].middlePx - names[k - 1].middlePx).toBeGreaterThanOrEqual(16);
});

test('none where rows have names of their own, or are in another order', () => {
  const few = testScene({ kind: 'label' });
  expect(groupNames(few, matrixGeometry(few, size, noZoom, 50))).toEqual([]);
  const byTree = { ...scene, kind: 'tree' as const };
  expect(groupNames(byTree, matrixGeometry(byTree, size, noZoom, 50))).toEqual([]);
});
