import { expect, test } from 'vitest';
import type { KeyposeResult } from '../engine/types';
import {
  areaPath,
  baseline,
  curveAt,
  curvePath,
  mostCurves,
  scaleAxis,
  whyCurves,
} from './why-layout';

const scales = (most: number, least: number, ratio: number): number[] => {
  const all: number[] = [];
  for (let i = 0, hz = most; hz >= least; hz = most * ratio ** ++i) all.push(hz);
  return all;
};

const ticksOf = (most: number, least: number, ratio: number, width = 272): number[] =>
  scaleAxis(scales(most, least, ratio), least, width).ticks.map(({ hz }) => hz);

/** Traces of candidates: u by scale from the finest on; those of `keyposes` are kept. */
function resultOf(traces: number[][], keyposes: number[]): KeyposeResult {
  const offsets = [0];
  for (const trace of traces) offsets.push((offsets.at(-1) ?? 0) + trace.length);
  const sum = (trace: number[]): number => trace.reduce((a, b) => a + b, 0);
  return {
    scalesHz: Float64Array.from(scales(8, 0.2, 0.95)),
    candidates: Int32Array.from(traces.keys()),
    traceOffsets: Int32Array.from(offsets),
    traceScales: Int32Array.from(traces.flatMap((trace) => [...trace.keys()])),
    traceIntensities: Float64Array.from(traces.flat()),
    byIntensity: Int32Array.from(
      [...traces.keys()].sort((a, b) => sum(traces[b]) - sum(traces[a])),
    ),
    keyposes: Int32Array.from(keyposes),
  } as unknown as KeyposeResult;
}

test('the axis of the defaults is that of the picture', () => {
  expect(ticksOf(8, 0.2, 0.95)).toEqual([8, 4, 2, 1, 0.5, 0.2]);
  const { x } = scaleAxis(scales(8, 0.4, 0.95), 0.2, 272);
  expect(x(8)).toBe(0);
  expect(x(0.2)).toBeCloseTo(272);
  expect(x(4) - x(8)).toBeCloseTo(x(2) - x(4));
});

test('other ranges have round ticks between their ends, without a crowd', () => {
  expect(ticksOf(6, 0.5, 0.9)).toEqual([6, 4, 2, 1, 0.5]);
  expect(ticksOf(100, 0.01, 0.5, 120).length).toBeLessThan(5);
  const ticks = scaleAxis(scales(10, 0.3, 0.95), 0.3, 252).ticks;
  ticks
    .slice(1)
    .forEach((tick, index) => expect(tick.x - (ticks[index]?.x ?? 0)).toBeGreaterThan(20));
});

test('one scale stands in the middle', () => {
  expect(scaleAxis([8], 8, 200).ticks).toEqual([{ hz: 8, x: 100 }]);
});

test('one vertical scale for all keyposes: the largest u is the highest', () => {
  const { curves } = whyCurves(resultOf([[1, 2], [4, 8, 2], [0.5]], [0, 1, 2]), 0.2, 272);
  const highest = curves.map(({ points }) => Math.min(...points.filter((_, at) => at % 2 === 1)));
  expect(highest[1]).toBeCloseTo(6 + (baseline - 6) * (1 - 1 / 1.05));
  expect(baseline - (highest[0] ?? 0)).toBeCloseTo((baseline - (highest[1] ?? 0)) / 4);
});

test('what is dropped has a curve on that scale too, and stays inside', () => {
  const { curves, curveOf } = whyCurves(resultOf([[1, 2], [40]], [0]), 0.2, 272);
  expect(curves.map(({ candidate }) => candidate)).toEqual([0]);
  expect(curveOf(1).points).toEqual([0, 6]);
});

test('a clip of thousands shows its most intense', () => {
  const traces = Array.from({ length: 5000 }, (_, at) => [1 + ((at * 7919) % 5000)]);
  const { curves } = whyCurves(resultOf(traces, [...traces.keys()]), 0.2, 272);
  expect(curves).toHaveLength(mostCurves);
  expect(curves[0]?.candidate).toBe(traces.findIndex(([u]) => u === 5000));
});

test('paths', () => {
  const curve = { candidate: 0, points: [0, 10, 5.04, 20] };
  expect(curvePath(curve)).toBe('M0 10L5 20');
  expect(areaPath(curve)).toBe(`M0 10L5 20L5 ${baseline}L0 ${baseline}Z`);
  expect(areaPath({ candidate: 0, points: [] })).toBe('');
});

test('the nearest curve is hit, from nearby', () => {
  const curves = [
    { candidate: 3, points: [0, 10, 5, 20] },
    { candidate: 4, points: [0, 30, 5, 30] },
  ];
  expect(curveAt(curves, 5, 22)).toBe(3);
  expect(curveAt(curves, 4, 27)).toBe(4);
  expect(curveAt(curves, 60, 22)).toBeNull();
});
