import { describe, expect, it } from 'vitest';
import { Axis } from './axis';
import { candidateAt } from './hit';
import { drawIntensityRow } from './intensity-row';
import type { Palette } from './palette';
import { layoutRows } from './rows';
import { drawScaleRow } from './scale-row';
import { sceneOf, type Scene } from './scene';
import { drawSpeedRow } from './speed-row';
import { testResult, type Size } from './test-result';
import { TimelineData } from './timeline-data';

const colours = Object.fromEntries(
  ['ink', 'text3', 'panel', 'raised', 'line1', 'line2', 'kp', 'kpLine'].map((name) => [name, name]),
) as unknown as Palette;

/** A context that draws nothing and counts what it is asked for. */
function countingContext(): { context: CanvasRenderingContext2D; calls: Map<string, number> } {
  const calls = new Map<string, number>();
  const context = new Proxy(
    {},
    {
      get: (_, name) => () => calls.set(String(name), (calls.get(String(name)) ?? 0) + 1),
      set: () => true,
    },
  );
  return { context: context as CanvasRenderingContext2D, calls };
}

function dataOf(size: Size): TimelineData {
  const data = new TimelineData(testResult(size));
  data.build(Infinity);
  return data;
}

function sceneFor(data: TimelineData, first: number, last: number): Scene {
  const axis = new Axis(1000, data.result.speed.length - 1, { first, last });
  return sceneOf(axis, layoutRows(new Set(), true), data, colours, null);
}

const hour: Size = { frames: 432_000, candidates: 30_000, keyposes: 5000 };
const clip: Size = { frames: 722, candidates: 59, keyposes: 11 };

describe('drawing the rows', () => {
  it('asks for a bounded number of strokes of an hour, at every zoom', () => {
    const data = dataOf(hour);
    for (const frames of [431_999, 144_000, 36_000, 7200, 1200, 20]) {
      const { context, calls } = countingContext();
      const scene = sceneFor(
        data,
        Math.min(1000, 431_999 - frames),
        Math.min(1000 + frames, 431_999),
      );
      for (const draw of [drawScaleRow, drawSpeedRow, drawIntensityRow]) draw(context, scene);
      expect([...calls.values()].reduce((sum, count) => sum + count)).toBeLessThan(25_000);
      expect(calls.get('arc') ?? 0).toBeLessThan(1000);
    }
  });

  it('leaves out the traces of candidates that are not keyposes where more than 300 are in view', () => {
    const pathsOf = (candidates: number): number => {
      const { context, calls } = countingContext();
      drawScaleRow(context, sceneFor(dataOf({ frames: 5000, candidates, keyposes: 10 }), 0, 4999));
      return calls.get('moveTo') ?? 0;
    };
    expect(pathsOf(300)).toBeGreaterThan(200);
    expect(pathsOf(301)).toBeLessThan(20);
  });

  it('bears a clip without keyposes or candidates, and one at rest', () => {
    const { context } = countingContext();
    const scene = sceneFor(dataOf({ frames: 50, candidates: 1, keyposes: 0 }), 0, 49);
    for (const draw of [drawScaleRow, drawSpeedRow, drawIntensityRow]) draw(context, scene);
    const still = { ...testResult(clip), maximumSpeed: 0, cut: null };
    const data = new TimelineData({ ...still, scalesHz: new Float64Array() });
    const empty = sceneOf(new Axis(1000, 721), layoutRows(new Set(), true), data, colours, null);
    for (const draw of [drawSpeedRow, drawIntensityRow]) draw(context, empty);
  });
});

describe('candidateAt', () => {
  const scene = sceneFor(dataOf(clip), 0, 721);
  const { rows, data, axis } = scene;
  const keypose = data.result.keyposes[4];
  const frame = data.result.candidates[keypose];

  it('finds the candidate of a trace, far from its own frame', () => {
    const heights = scene.scaleHeights;
    expect(candidateAt(scene, axis.x(frame + 0.4 * 15), heights[15])).toBe(frame);
    expect(candidateAt(scene, axis.x(frame) + 25, heights[15])).toBeNull();
  });

  it('finds the dot of an intensity', () => {
    const y = rows.intensity.top + rows.intensity.height - 5;
    expect(candidateAt(scene, axis.x(data.result.candidates[8]) + 1, y)).toBe(
      data.result.candidates[8],
    );
  });

  it('finds nothing in other rows', () => {
    expect(candidateAt(scene, axis.x(frame), rows.speed.top + 20)).toBeNull();
  });
});
