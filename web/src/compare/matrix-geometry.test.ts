import { expect, test } from 'vitest';
import { matrixGeometry, noZoom, topPx, zoomShowing, zoomedBy } from './matrix-geometry';
import { testScene } from './test-scene';

const scene = testScene();
const size = { width: 780, height: 590 };

test('tree, names and matrix stand beside each other in the room there is', () => {
  const geometry = matrixGeometry(scene, size, noZoom, 50);
  expect(geometry.treeWidth).toBe(146);
  expect(geometry.left).toBe(geometry.namesLeft + geometry.namesWidth);
  expect(geometry.left + geometry.side).toBeLessThanOrEqual(size.width);
  expect(topPx + geometry.side).toBeLessThanOrEqual(size.height);
  expect(geometry.named).toBe(true);
});

test('another order leaves the matrix where it is, and gives the names the tree’s room', () => {
  const tree = matrixGeometry(scene, size, noZoom, 150);
  const byName = matrixGeometry(testScene({ kind: 'name' }), size, noZoom, 150);
  expect(byName.left).toBe(tree.left);
  expect(byName.treeWidth).toBe(0);
  expect(byName.namesWidth).toBeGreaterThan(tree.namesWidth);
});

const many = { ...scene, groups: new Int32Array(1000) };

test('zooming holds what is under the pointer, and never goes beyond the whole', () => {
  const whole = matrixGeometry(many, size, noZoom, 50);
  expect(whole.named).toBe(false);
  const zoom = zoomedBy(whole, 4, 100, 200);
  const near = matrixGeometry(many, size, zoom, 50);
  const under = (axisPx: number, cell: number): number => axisPx / cell;
  expect(under(near.zoom.x + 100, near.axis.cell)).toBeCloseTo(under(100, whole.axis.cell));
  expect(under(near.zoom.y + 200, near.axis.cell)).toBeCloseTo(under(200, whole.axis.cell));
  expect(zoomedBy(near, 0.001, 0, 0).cell).toBeNull();
});

test('a cell out of sight comes into sight with the least movement', () => {
  const near = matrixGeometry(many, size, { cell: 18, x: 0, y: 0 }, 50);
  const { x, y } = zoomShowing(near, 2, 999);
  expect(y).toBe(0);
  expect(x + near.side).toBeCloseTo(near.axis.length);
});
