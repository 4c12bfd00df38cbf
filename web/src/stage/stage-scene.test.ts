import { InstancedBufferGeometry, type Mesh, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import type { PoseSource } from '../engine/pose-source';
import { asRecorded, placed } from '../figure/placement';
import { animal, human, standingPose } from '../figure/test-bodies';
import type { StagePerformer } from './figure-set';
import type { Ray } from './pick';
import type { StageGhost } from './stage-props';
import { StageScene } from './stage-scene';

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
  return {
    ...human,
    unit: null,
    leadingRestFrames: 0,
    ...yaws,
    source: sourceOf(frames),
    ...change,
  };
}

const moved = (x: number, z: number): Float32Array =>
  standingPose.map((value, i) => value + [x, 0, z][i % 3]);

const ghost = (pose: Float32Array): StageGhost => ({ tag: '1', pose });

/** Instances of what is seen of figures in the scene; background, ground and heralds have none. */
function instances(stage: StageScene): number[] {
  return stage.scene.children
    .filter(({ visible }) => visible)
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

  it('draws a ghost for each pose of another moment, in two calls, until there are other poses', () => {
    const stage = new StageScene();
    stage.setPerformers([performerOf([standingPose])]);
    stage.setGhosts([moved(2, 0), moved(-3, 0)].map(ghost));
    stage.showFrame(0);
    expect(instances(stage)).toEqual([22, 22, 22, 22, 22]);
    expect(stage.ghostViews.slice(0, 3).map((ghost) => ghost?.x)).toEqual([1, -1.5, undefined]);
    expect(stage.place.ghosts).toBeCloseTo(1.5, 6);
    stage.setGhosts([moved(1, 0)].map(ghost));
    expect(instances(stage)).toEqual([22, 22, 22]);
    stage.setGhosts([]);
    expect(instances(stage)).toEqual([22]);
  });

  it('has no ghost in the way of the camera that only passes', () => {
    const stage = new StageScene();
    stage.setPerformers([performerOf([standingPose])]);
    stage.setGhosts([{ tag: '', pose: moved(9, 0) }]);
    stage.showFrame(0);
    expect(stage.ghostViews[0]?.x).toBeCloseTo(4.5, 6);
    expect(stage.place.ghosts).toBe(0);
  });

  it('draws the farther ghost before the nearer one', () => {
    const stage = new StageScene();
    stage.setPerformers([performerOf([standingPose])]);
    stage.setGhosts([moved(0, 4), moved(0, -4)].map(ghost));
    stage.showFrame(0);
    const orders = (): number[] =>
      stage.scene.children.map(({ renderOrder }) => renderOrder).filter((order) => order > 1);
    stage.setEye(new Vector3(0, 1, 9));
    const fromFront = orders();
    stage.setEye(new Vector3(0, 1, -9));
    expect(orders()).not.toEqual(fromFront);
    expect(new Set(orders().slice(0, 4))).toEqual(new Set([2, 3, 4, 5]));
  });

  it('draws two keyposes on either side and the moment under the pointer', () => {
    const stage = new StageScene();
    stage.setPerformers([performerOf([standingPose])]);
    stage.setGhosts([1, 2, 3, 4, 5].map((x) => ghost(moved(x, 0))));
    stage.showFrame(0);
    expect(stage.ghostViews.filter((view) => view !== null).length).toBe(5);
  });

  it('has ghosts of the chosen performer, and none of a pose that is not its', () => {
    const stage = new StageScene();
    stage.setPerformers([performerOf([standingPose]), performerOf([moved(4, 0)])]);
    stage.setGhosts([moved(8, 0)].map(ghost));
    stage.setChosen(1);
    stage.showFrame(0);
    expect(stage.chosenFigure?.x).toBeCloseTo(2, 6);
    expect(stage.ghostViews[0]?.x).toBeCloseTo(4, 6);
    stage.setGhosts([new Float32Array(6)].map(ghost));
    expect(stage.ghostViews[0]).toBeNull();
  });

  it('hides a figure without a place, says so, and stays where it was', () => {
    const stage = new StageScene();
    const lost = standingPose.slice();
    lost[4] = NaN;
    const far = standingPose.map((value) => value * 1e30);
    stage.setPerformers([performerOf([moved(2, 0), lost, far, standingPose])]);
    stage.showFrame(0);
    for (const frame of [1, 2]) {
      expect(stage.showFrame(frame)).toBe(true);
      expect([stage.drawable, instances(stage)]).toEqual([false, []]);
      expect(stage.place.x).toBeCloseTo(1, 6);
    }
    stage.showFrame(3);
    expect([stage.drawable, instances(stage)]).toEqual([true, [22]]);
  });

  it('greys a figure in its leading rest frames', () => {
    const stage = new StageScene();
    stage.setPerformers([performerOf([standingPose, standingPose], { leadingRestFrames: 1 })]);
    stage.showFrame(0);
    expect(stage.figures[0].resting).toBe(true);
    stage.showFrame(1);
    expect(stage.figures[0].resting).toBe(false);
  });

  it('finds the joint that a ray meets, on the nearest figure', () => {
    const stage = new StageScene();
    stage.setPerformers([performerOf([standingPose]), performerOf([moved(0, 4)])]);
    stage.showFrame(0);
    const wrist = 8;
    const toward: Ray = { origin: [0.44, 0.775, 9], direction: [0, 0, -1] };
    expect(stage.pick(toward)).toEqual({ performer: 1, joint: wrist });
    const behind: Ray = { origin: [0.44, 0.775, -9], direction: [0, 0, 1] };
    expect(stage.pick(behind)).toEqual({ performer: 0, joint: wrist });
    expect(stage.pick({ ...toward, origin: [0.44, 0.9, 9] })).toBeNull();
  });

  it('lets a shorter performer stay at its last frame', () => {
    const stage = new StageScene();
    stage.setPerformers([performerOf([standingPose, moved(2, 0)]), performerOf([standingPose])]);
    expect(stage.showFrame(1)).toBe(true);
    expect(stage.place.x).toBeCloseTo(0.5, 6);
  });

  it('shows clips of different lengths and scales, each at a frame of its own and where it is placed', () => {
    const stage = new StageScene();
    const double = standingPose.map((value) => value * 2);
    const tall = { ...animal.body, height: 4 };
    const beside = { ...asRecorded, x: 1, z: -2 };
    stage.setPerformers([
      performerOf([standingPose, moved(2, 0), moved(4, 0)], { placement: asRecorded, tint: 0 }),
      performerOf([double], { body: tall, placement: beside, tint: 1 }),
    ]);
    expect(stage.showFrame([2, 0])).toBe(true);
    const [a, b] = stage.figures;
    expect([a.x, b.x, b.z]).toEqual([2, 1, -2]);
    expect(b.pose.top).toBeCloseTo(a.pose.top, 6);
    expect([a.tint, b.tint]).toEqual([0, 1]);
  });

  it('mirrors a figure: what was its left arm is its right one', () => {
    const stage = new StageScene();
    const stand = { x: 0, z: 0, yawRad: 0 };
    stage.setPerformers([
      performerOf([standingPose]),
      performerOf([standingPose], { placement: placed(stand, stand, true) }),
    ]);
    stage.showFrame(0);
    const [plain, mirrored] = stage.figures.map(({ pose }) => pose);
    const wrist = 8 * 3;
    expect(mirrored.joints[wrist]).toBeCloseTo(-plain.joints[wrist], 6);
    const sides = (bones: typeof plain.bones): string[] => bones.map(({ side }) => side);
    expect(sides(plain.bones)[0]).toBe('left');
    expect(sides(mirrored.bones)[0]).toBe('right');
  });
});
