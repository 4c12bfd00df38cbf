import { expect, test } from 'vitest';
import { convexHull, type Point } from './hull';
import {
  between,
  fitMap,
  keptFit,
  middleMember,
  nearestTowards,
  onScreen,
  placeFigures,
  pointAt,
  zoomed,
} from './map-layout';

const room = { left: 0, top: 0, right: 200, bottom: 100 };

test('the hull has the corners and leaves out what is inside', () => {
  const points: Point[] = [
    [0, 0],
    [2, 0],
    [1, 1],
    [2, 2],
    [0, 2],
  ];
  expect(convexHull(points)).toHaveLength(4);
  expect(convexHull(points)).not.toContainEqual([1, 1]);
});

test('points on a line or all in one place have a hull too', () => {
  const line: Point[] = [
    [0, 0],
    [1, 1],
    [2, 2],
  ];
  expect(convexHull(line).length).toBeGreaterThan(0);
  expect(convexHull([...Array<Point>(3)].map((): Point => [4, 4]))).toContainEqual([4, 4]);
});

test('the map fills its room at one scale for both axes, upward is up', () => {
  const transform = fitMap(Float64Array.of(0, 0, 1, 1), room);
  expect(transform.scale).toBe(100);
  expect(onScreen(transform, [0, 0])).toEqual([50, 100]);
  expect(onScreen(transform, [1, 1])).toEqual([150, 0]);
});

test('clips all in one place stand in the middle', () => {
  const transform = fitMap(Float64Array.of(3, 3, 3, 3), room);
  expect(onScreen(transform, [3, 3])).toEqual([100, 50]);
});

test('the map is fitted anew only where something is out of sight or all is small', () => {
  const usual = { left: 50, top: 50, right: 150, bottom: 150 };
  const outer = { left: 0, top: 0, right: 200, bottom: 200 };
  const fit = fitMap(Float64Array.of(0, 0, 1, 1), usual);
  const kept = (...places: number[]) => keptFit(fit, Float64Array.from(places), { usual, outer });
  expect(kept(0, 0, 1.4, 1)).toBe(fit);
  expect(kept(0, 0, 0.8, 0.8)).toBe(fit);
  expect(kept(0, 0, 1, 1.6).scale).toBeCloseTo(100 / 1.6);
  expect(kept(-0.6, 0, 1, 1).scale).toBeCloseTo(100 / 1.6);
  expect(kept(0, 0, 0.5, 0.5).scale).toBe(200);
});

test('zooming holds the point under the pointer', () => {
  const transform = fitMap(Float64Array.of(0, 0, 1, 1), room);
  expect(onScreen(zoomed(transform, 3, 150, 0), [1, 1])).toEqual([150, 0]);
});

test('on their way places are in between', () => {
  expect([...between(Float64Array.of(0, 4), Float64Array.of(2, 0), 0.25)]).toEqual([0.5, 3]);
});

test('a cluster’s figure is the member nearest to its middle', () => {
  const places = Float64Array.of(0, 0, 10, 0, 4, 1);
  expect(middleMember([0, 1, 2], places)).toBe(2);
});

test('figures cover neither discs nor each other', () => {
  const points: Point[] = [
    [100, 50],
    [104, 52],
  ];
  const size = { width: 40, height: 40 };
  const figures = placeFigures(
    points.map((at) => ({ at, hull: [at] })),
    { room, ...size, points, radius: 5, taken: [] },
  );
  const [first, second] = figures as [Point, Point];
  expect(Math.max(Math.abs(first[0] - second[0]), Math.abs(first[1] - second[1]))).toBeGreaterThan(
    39.9,
  );
  for (const [x, y] of [first, second])
    for (const point of points)
      expect(Math.max(Math.abs(x - point[0]), Math.abs(y - point[1]))).toBeGreaterThan(24.9);
});

test('a figure stands beside the hull of its cluster, not within', () => {
  const hull: Point[] = [
    [60, 20],
    [140, 20],
    [140, 80],
    [60, 80],
  ];
  const wide = { left: -200, top: -200, right: 400, bottom: 400 };
  const figures = { room: wide, width: 20, height: 20, points: hull, radius: 5, taken: [] };
  const [place] = placeFigures([{ at: [100, 50], hull }], figures);
  const [x, y] = place as Point;
  expect(x < 50 || x > 150 || y < 10 || y > 90).toBe(true);
});

test('where there is no room there is no figure', () => {
  const small = { left: 0, top: 0, right: 30, bottom: 30 };
  const figures = { room: small, width: 40, height: 40, points: [], radius: 5, taken: [] };
  expect(placeFigures([{ at: [10, 10], hull: [] }], figures)).toEqual([null]);
});

test('an arrow key goes to the nearest clip in its direction', () => {
  const points: Point[] = [
    [0, 0],
    [10, 0],
    [5, 4],
    [0, 7],
    [-3, 0],
  ];
  expect(nearestTowards(points, 0, 'right')).toBe(1);
  expect(nearestTowards(points, 0, 'down')).toBe(3);
  expect(nearestTowards(points, 0, 'left')).toBe(4);
  expect(nearestTowards(points, 0, 'up')).toBe(-1);
});

test('a press takes the nearest disc within reach', () => {
  const points: Point[] = [
    [0, 0],
    [10, 0],
  ];
  expect(pointAt(points, 6, 0, 9)).toBe(1);
  expect(pointAt(points, 50, 0, 9)).toBe(-1);
});
