/** Lifetimes and refusals at the border to the core. */
import { beforeAll, describe, expect, it } from 'vitest';
import { CoreFailure } from './core-failure';
import type { Core, CoreClip } from './raw';
import { testCore } from './test-engine';

let core: Core;
let walk: Uint8Array<ArrayBuffer>;

beforeAll(async () => {
  core = await testCore();
  walk = core.sample('walk') ?? new Uint8Array();
});

function read(bytes: Uint8Array, sliceBytes = bytes.length): CoreClip {
  const clip = core.newClip();
  clip.beginReading(bytes.length);
  for (let at = 0; at < bytes.length; at += sliceBytes)
    clip.push(bytes.subarray(at, at + sliceBytes));
  clip.endReading();
  return clip;
}

function analysed(clip: CoreClip): CoreClip {
  clip.beginAnalysis({}, {});
  while (clip.step() < 1);
  return clip;
}

describe('a clip in the core', () => {
  it('cannot be used after it was freed, nor freed twice', () => {
    const clip = read(walk);
    clip.free();
    expect(() => clip.hasMotion()).toThrow(/null pointer/);
    expect(() => clip.poseRange(0, 0, 1)).toThrow(/null pointer/);
    expect(() => clip.step()).toThrow(/null pointer/);
    expect(() => clip.free()).toThrow(/null pointer/);
  });

  it('lives beside others', () => {
    const [one, other] = [read(walk), read(walk, 1000)];
    const before = one.poseRange(0, 0, 5);
    expect(other.poseRange(0, 0, 5)).toEqual(before);
    other.free();
    expect(one.poseRange(0, 0, 5)).toEqual(before);
    one.free();
  });

  it('gives copies, which later work does not touch', () => {
    const clip = read(walk);
    const poses = clip.poseRange(0, 0, 100);
    const kept = poses.slice();
    analysed(clip);
    read(walk).free();
    expect(poses).toEqual(kept);
    clip.free();
  });

  it('keeps its results when its motion is dropped, and can be read again', () => {
    const clip = analysed(read(walk));
    const result = clip.result();
    expect(clip.motionBytes()).toBeGreaterThan(100_000);
    clip.dropMotion();
    expect(clip.motionBytes()).toBe(0);
    expect(clip.result()).toEqual(result);
    expect(() => clip.poseRange(0, 0, 1)).toThrow('poses: there is no motion');
    clip.beginReading(walk.length);
    clip.push(walk);
    clip.endReading();
    expect(analysed(clip).result()).toEqual(result);
    clip.free();
  });

  it('gives the rows of the file, to the last bit', () => {
    const clip = read(walk);
    const lines = new TextDecoder().decode(walk).trimEnd().split('\n').slice(-3);
    const expected = lines.flatMap((line) => line.trim().split(' ').map(Number));
    const frames = analysed(clip).result().frames;
    expect(clip.rows(frames - 3, 3)).toEqual(Float64Array.from(expected));
    expect(clip.rows(frames, 0)).toHaveLength(0);
    expect(() => clip.rows(frames - 3, 4)).toThrow('rows: the clip has fewer');
    clip.free();
  });

  it('refuses calls out of order, in words', () => {
    const clip = core.newClip();
    expect(() => clip.push(walk)).toThrow('push: beginReading must come first');
    expect(() => clip.endReading()).toThrow('endReading: beginReading must come first');
    expect(() => clip.step()).toThrow('step: there is no motion');
    expect(() => clip.beginAnalysis({}, {})).toThrow('beginAnalysis: there is no motion');
    expect(() => clip.result()).toThrow('there are no results yet');
    clip.free();
  });

  it('refuses frames and performers that are not there, with the numbers', () => {
    const clip = read(walk);
    expect(() => clip.poses(0, Int32Array.of(0, -1))).toThrow(
      /frame -1 asked for, the clip has \d+/,
    );
    expect(() => clip.poseRange(0, 1e6, 1)).toThrow(/frame 1000000 asked for, the clip has \d+/);
    expect(() => clip.poseRange(1, 0, 1)).toThrow('performer 1 asked for, the clip has 1');
    clip.free();
  });

  it('tells the failure of a file with its place', () => {
    const text = new TextEncoder().encode('HIERARCHY\nROOT a\n{\n OFFSET 0 0\n}\n');
    let failure: unknown;
    try {
      read(text);
    } catch (error) {
      failure = error instanceof CoreFailure ? error.failure : error;
    }
    expect(failure).toMatchObject({ kind: 'short-offset', line: 4, details: ['a', '2'] });
  });

  it('shows the skeleton of a file without motion', () => {
    const end = new TextDecoder().decode(walk).indexOf('MOTION');
    const head = `${new TextDecoder().decode(walk.subarray(0, end))}MOTION\nFrames: 0\nFrame Time: 0.01\n`;
    const clip = analysed(read(new TextEncoder().encode(head)));
    const result = clip.result();
    expect(result.frames).toBe(0);
    expect(result.performers[0]?.keyposes).toBeNull();
    expect(result.performers[0]?.unanalysed?.kind).toBe('no-motion');
    expect(clip.poses(0, Int32Array.of(0)).some((value) => value !== 0)).toBe(true);
    clip.free();
  });

  it('refuses unknown settings by name', () => {
    const clip = read(walk);
    const bad = (decisions: object) => () => clip.beginAnalysis(decisions, {});
    expect(bad({ up: 'up' })).toThrow(CoreFailure);
    expect(bad({ unit: 'ell' })).toThrow(CoreFailure);
    expect(bad({ leadingRestFrames: 1.5 })).toThrow(CoreFailure);
    expect(bad({ frameRateHz: Number.NaN })).toThrow(CoreFailure);
    clip.free();
  });
});

describe('a joint that a person decided', () => {
  it('changes the body and is taken back without a trace', () => {
    const clip = analysed(read(walk));
    const first = clip.result();
    const elbow = first.performers[0]?.body.joints.find(({ role }) => role === 'left_elbow');
    const joint = elbow?.joint ?? -1;
    const decided = { joints: [{ performer: 0, role: 'left_wrist', joint }] } as const;
    clip.beginAnalysis(decided, {});
    while (clip.step() < 1);
    const second = clip.result();
    expect(second.performers[0]?.body.joints).toContainEqual({
      role: 'left_wrist',
      joint,
      source: 'user',
    });
    expect(second.performers[0]?.keyposes?.speed).not.toEqual(first.performers[0]?.keyposes?.speed);
    expect(analysed(clip).result()).toEqual(first);
    clip.free();
  });

  it('must be in the clip', () => {
    const clip = read(walk);
    const refused = (performer: number, joint: number): unknown => {
      try {
        clip.beginAnalysis({ joints: [{ performer, role: 'pelvis', joint }] }, {});
      } catch (error) {
        return error instanceof CoreFailure ? error.failure.details : error;
      }
      return null;
    };
    const rule = 'a joint of the clip';
    expect(refused(0, 9999)).toEqual(['joints', 'pelvis = joint 9999 of performer 0', rule]);
    expect(refused(1, 0)).toEqual(['joints', 'pelvis = joint 0 of performer 1', rule]);
    expect(refused(0, 0.5)).toEqual(['joints', '0.5', 'a whole number from 0']);
    clip.free();
  });
});

it('says why each keypose is one', () => {
  const clip = analysed(read(walk));
  const found = clip.result().performers[0];
  const why = found?.keyposes;
  if (!found || !why) throw new Error('no keyposes');
  const count = why.candidates.length;
  expect([...why.byIntensity].sort((a, b) => a - b)).toEqual([...Array(count).keys()]);
  const sorted = Array.from(why.byIntensity, (index) => why.intensities[index] ?? 0);
  expect(sorted).toEqual([...sorted].sort((a, b) => b - a));
  expect(why.tracePlaces).toHaveLength(why.traceFrames.length);
  expect(why.tracePlaces.every((at, k) => Math.abs(at - (why.traceFrames[k] ?? 0)) <= 0.5)).toBe(
    true,
  );
  for (const [candidate, scale] of why.strongestScales.entries()) {
    const [from, to] = [why.traceOffsets[candidate] ?? 0, why.traceOffsets[candidate + 1] ?? 0];
    const trace = [...why.traceIntensities.subarray(from, to)];
    expect(scale).toBe(trace.length === 0 ? -1 : trace.indexOf(Math.max(...trace)));
  }
  expect(why.bodyPartPercents).toHaveLength(5 * why.keyposes.length);
  expect(why.postures).toHaveLength(why.keyposes.length);
  expect(why.postures.flat().some((word) => word.endsWith('-leg-forward'))).toBe(true);
  const { labels } = found.skeleton;
  expect(Array.from(found.trailJoints, (joint) => labels[joint])).toHaveLength(2);
  clip.free();
});
