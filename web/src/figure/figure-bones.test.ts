import { describe, expect, it } from 'vitest';
import { type BoneCone, CONE_STRIDE, writeCones } from './bone-cone';
import { figureBones } from './figure-bones';
import { LIMBS } from './human-bones';
import { spineRadius } from './radii';
import { animal, human, standingPose } from './test-bodies';

/** The pose in body heights. */
const joints = standingPose.map((value) => value / 2);
const bonesOf = (performer: typeof human): BoneCone[] =>
  figureBones(performer.skeleton, performer.body, joints);
const jointOf = (label: string): number => human.skeleton.labels.indexOf(label);

function conesOf(bones: readonly BoneCone[]): Float32Array {
  const out = new Float32Array(bones.length * CONE_STRIDE);
  expect(writeCones(bones, joints, 1, out, 0)).toBe(out.length);
  return out;
}

describe('a human figure', () => {
  const bones = bonesOf(human);

  it('has the radii of the design from hip to toe', () => {
    const leg = bones.filter((bone) => bone.limb === LIMBS.leftLeg);
    expect(leg[0]).toMatchObject({ startRadius: 0.043, endRadius: 0.031, side: 'left' });
    expect(leg[1]).toMatchObject({ startRadius: 0.031, endRadius: 0.02 });
    expect(leg[2].startRadius).toBe(0.02);
    expect(leg[leg.length - 1].endRadius).toBeCloseTo(0.013, 12);
    expect(leg[leg.length - 1].end.to).toBe(jointOf('LeftToeBase/end'));
  });

  it('bends the foot at its ball', () => {
    const leg = bones.filter((bone) => bone.limb === LIMBS.rightLeg);
    expect(leg).toHaveLength(4);
    expect(leg[2].end.to).toBe(jointOf('RightToeBase'));
    expect(leg[2].endRadius).toBeCloseTo(leg[3].startRadius, 12);
  });

  it('ends its arms in the fingers', () => {
    const arm = bones.filter((bone) => bone.limb === LIMBS.rightArm);
    expect(arm.map((bone) => bone.end.to)).toEqual(
      ['RightForeArm', 'RightHand', 'RightHand/end'].map(jointOf),
    );
    expect(arm.every((bone) => bone.side === 'right')).toBe(true);
  });

  it('lets the shoulders leave the spine at 0.7 of its length', () => {
    const cones = conesOf(bones);
    const shoulder = bones.findIndex((bone) => bone.end.to === jointOf('LeftArm'));
    const chestHeight = cones[shoulder * CONE_STRIDE + 1];
    expect(chestHeight).toBeCloseTo((1 + 0.7 * 0.6) / 2, 6);
    expect(cones[shoulder * CONE_STRIDE]).toBeCloseTo(0, 9);
  });

  it('sets the head just under its tip', () => {
    const cones = conesOf(bones);
    const head = (bones.length - 1) * CONE_STRIDE;
    expect(cones[head + 5]).toBeCloseTo(0.975 - 0.025, 6);
    expect(cones[head + 7]).toBeCloseTo(0.046, 6);
  });

  it('has at most 22 cones, what fits the triangles of a figure', () => {
    expect(bones.length).toBeLessThanOrEqual(22);
  });

  it('draws what it can where roles are missing', () => {
    const body = {
      ...human.body,
      joints: human.body.joints.filter(({ role }) => role !== 'neck' && role !== 'left_wrist'),
    };
    const fewer = figureBones(human.skeleton, body, joints);
    expect(fewer.length).toBeGreaterThan(8);
    expect(conesOf(fewer).every(Number.isFinite)).toBe(true);
  });

  it('stays finite when all joints lie in one point', () => {
    const nowhere = new Float32Array(joints.length);
    const out = new Float32Array(64 * CONE_STRIDE);
    writeCones(figureBones(human.skeleton, human.body, nowhere), nowhere, 1, out, 0);
    expect(out.every(Number.isFinite)).toBe(true);
  });
});

describe('a figure that is not human', () => {
  it('has one bone for each parent and child, in the trunk colour', () => {
    const bones = bonesOf(animal);
    expect(bones).toHaveLength(animal.skeleton.parents.length - 1);
    expect(bones.every((bone) => bone.side === 'trunk' && bone.startRadius === 0.018)).toBe(true);
  });

  it('makes one limb of a chain, and others of its branches', () => {
    const limbOf = new Map(bonesOf(animal).map((bone) => [bone.end.to, bone.limb]));
    expect(limbOf.get(jointOf('LeftUpLeg'))).toBe(limbOf.get(jointOf('LeftToeBase/end')));
    expect(limbOf.get(jointOf('LeftUpLeg'))).not.toBe(limbOf.get(jointOf('RightUpLeg')));
    expect(limbOf.get(jointOf('Chest'))).not.toBe(limbOf.get(jointOf('Neck')));
  });
});

describe('spineRadius', () => {
  it('passes through its profile and narrows towards the neck', () => {
    expect(spineRadius(0)).toBe(0.05);
    expect(spineRadius(0.7)).toBeCloseTo(0.052, 12);
    expect(spineRadius(1)).toBeCloseTo(0.024, 12);
    expect(spineRadius(0.85)).toBeCloseTo(0.038, 12);
  });
});
