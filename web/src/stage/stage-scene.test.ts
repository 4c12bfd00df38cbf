import { InstancedBufferGeometry, type Mesh } from 'three';
import { describe, expect, it } from 'vitest';
import type { PoseSource } from '../engine/pose-source';
import { animal, human, standingPose } from '../figure/test-bodies';
import { type StagePerformer, StageScene } from './stage-scene';

function sourceOf(frames: readonly (Float32Array | null)[]): PoseSource {
  return {
    jointCount: standingPose.length / 3,
    frames: frames.length,
    read: (frame) => frames[frame] ?? null,
    prefetch: () => undefined,
    onArrive: () => () => undefined,
    destroy: () => undefined,
  };
}

function performerOf(
  frames: readonly (Float32Array | null)[],
  change: Partial<StagePerformer> = {},
): StagePerformer {
  const yaws = { sideYawRad: 0, frontYawRad: 0 };
  return { ...human, unit: null, ...yaws, source: sourceOf(frames), ...change };
}

const moved = (x: number, z: number): Float32Array =>
  standingPose.map((value, i) => value + [x, 0, z][i % 3]);

/** Instances of the figures in the scene; background, ground and herald have none. */
function instances(stage: StageScene): number[] {
  return stage.scene.children
    .map((child) => (child as Mesh).geometry)
    .filter((geometry) => geometry instanceof InstancedBufferGeometry)
    .map((geometry) => geometry.instanceCount)
    .filter((count) => count > 0);
}

describe('StageScene', () => {
  it('shows nothing until every performer has its pose, then one mesh for each', () => {
    const stage = new StageScene();
    stage.setPerformers([
      performerOf([standingPose, standingPose]),
      performerOf([null, standingPose]),
    ]);
    expect(stage.showFrame(0)).toBe(false);
    expect(instances(stage)).toEqual([]);
    expect(stage.showFrame(1)).toBe(true);
    expect(instances(stage)).toEqual([22, 22]);
  });

  it('keeps the old figures until the new ones come, and none without performers', () => {
    const stage = new StageScene();
    stage.setPerformers([performerOf([standingPose])]);
    stage.showFrame(0);
    stage.setPerformers([performerOf([null], { body: animal.body })]);
    expect(stage.showFrame(0)).toBe(false);
    expect(instances(stage)).toEqual([22]);
    expect(stage.ready).toBe(false);
    stage.setPerformers([performerOf([standingPose], { body: animal.body })]);
    stage.showFrame(0);
    expect(instances(stage)).toEqual([human.skeleton.parents.length - 1]);
    stage.setPerformers([]);
    expect(instances(stage)).toEqual([]);
  });

  it('finds the middle of the figures and how far they stand from it, in body heights', () => {
    const stage = new StageScene();
    stage.setPerformers([performerOf([moved(4, 2)]), performerOf([moved(0, 2)])]);
    stage.showFrame(0);
    expect(stage.place.x).toBeCloseTo(1, 6);
    expect(stage.place.z).toBeCloseTo(1, 6);
    expect(stage.place.reach).toBeCloseTo(1, 6);
  });

  it('lets a shorter performer stay at its last frame', () => {
    const stage = new StageScene();
    stage.setPerformers([performerOf([standingPose, moved(2, 0)]), performerOf([standingPose])]);
    expect(stage.showFrame(1)).toBe(true);
    expect(stage.place.x).toBeCloseTo(0.5, 6);
  });
});
