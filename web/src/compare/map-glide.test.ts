import { batch, signal } from '@preact/signals-core';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { Arrived } from './map-arrivals';
import { MapGlide, oldPlaces, type Laid } from './map-glide';
import type { MapRoom } from './map-layout';
import type { Scene } from './scene';
import { testComparison, testScene } from './test-scene';

const fit = { scale: 1, x: 0, y: 0 };

test('a clip glides from where it stood; a new one stands at its place at once', () => {
  const before: Laid = { clips: [7, 8], places: Float64Array.of(1, 2, 3, 4), fit };
  const after: Laid = { clips: [8, 9], places: Float64Array.of(10, 20, 30, 40), fit };
  expect([...oldPlaces(before, after)]).toEqual([3, 4, 30, 40]);
});

let frames: (() => void)[] = [];
let nowMs = 0;

beforeEach(() => {
  frames = [];
  nowMs = 0;
  vi.stubGlobal('matchMedia', () => ({ matches: false }));
  vi.stubGlobal('requestAnimationFrame', (frame: () => void) => frames.push(frame));
  vi.stubGlobal('cancelAnimationFrame', () => (frames = []));
  vi.spyOn(performance, 'now').mockImplementation(() => nowMs);
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

/** Lets time pass and draws a frame. */
function frameAfter(ms: number): void {
  nowMs += ms;
  for (const frame of frames.splice(0)) frame();
}

const room: MapRoom = {
  usual: { left: 50, top: 50, right: 150, bottom: 150 },
  outer: { left: 0, top: 0, right: 200, bottom: 200 },
};

const arrivedAt = (clip: number, x: number, y: number): Arrived => ({
  clip,
  place: [x, y],
  name: String(clip),
  label: -1,
});

/** The scene of the tests with its clips and places replaced. */
const sceneWith = (clips: number[], map: number[]): Scene => {
  const scene = testScene();
  const comparison = {
    ...testComparison,
    clips: Int32Array.from(clips),
    map: Float64Array.from(map),
  };
  return { ...scene, comparison, count: clips.length };
};

function setUp() {
  const scene = signal<Scene | null>(sceneWith([0, 1], [0, 0, 10, 10]));
  const arrived = signal<readonly Arrived[]>([]);
  const glide = new MapGlide(scene, arrived, signal<MapRoom | null>(room));
  return { scene, arrived, glide };
}

test('what arrives moves nothing, neither places nor the way the map fits', () => {
  const { arrived, glide } = setUp();
  const [places, before] = [glide.places.value, glide.fit.value];
  arrived.value = [arrivedAt(5, 12, 4)];
  expect(glide.places.value).toBe(places);
  expect(glide.fit.value).toBe(before);
  expect([...glide.arrivedPlaces.value]).toEqual([12, 4]);
  expect(glide.gliding.value).toBe(false);
});

test('the full layout glides from where clips stood, those that had arrived too', () => {
  const { scene, arrived, glide } = setUp();
  arrived.value = [arrivedAt(5, 12, 4)];
  batch(() => {
    arrived.value = [];
    scene.value = sceneWith([0, 1, 5], [1, 0, 10, 9, 8, 4]);
  });
  expect([...glide.places.value]).toEqual([0, 0, 10, 10, 12, 4]);
  frameAfter(200);
  expect(glide.places.value[4]).toBeLessThan(12);
  expect(glide.places.value[4]).toBeGreaterThan(8);
  frameAfter(300);
  expect([...glide.places.value]).toEqual([1, 0, 10, 9, 8, 4]);
  expect(glide.gliding.value).toBe(false);
});

test('clips that keep their places in a larger comparison stand still', () => {
  const { scene, arrived, glide } = setUp();
  arrived.value = [arrivedAt(5, 12, 4)];
  batch(() => {
    arrived.value = [];
    scene.value = sceneWith([0, 1, 5], [0, 0, 10, 10, 12, 4]);
  });
  expect(frames).toEqual([]);
  expect([...glide.places.value]).toEqual([0, 0, 10, 10, 12, 4]);
});

test('what arrives during a glide does not begin it anew', () => {
  const { scene, arrived, glide } = setUp();
  scene.value = sceneWith([0, 1], [4, 0, 10, 10]);
  frameAfter(390);
  arrived.value = [arrivedAt(5, 6, 6)];
  frameAfter(20);
  expect(glide.gliding.value).toBe(false);
  expect([...glide.places.value]).toEqual([4, 0, 10, 10]);
});

test('what would be out of sight makes the map fit again, gliding', () => {
  const { arrived, glide } = setUp();
  const before = glide.fit.value;
  arrived.value = [arrivedAt(5, 40, 5)];
  expect(glide.fit.value).toEqual(before);
  frameAfter(500);
  expect(glide.fit.value.scale).toBeLessThan(before.scale);
});
