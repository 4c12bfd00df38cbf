import { describe, expect, it } from 'vitest';
import { animal, human, standingPose } from '../figure/test-bodies';
import { sceneFrameOf } from '../figure/up-frame';
import { ConeTexture, TEXTURE_STRIDE } from './cone-texture';
import { FigurePose } from './figure-pose';

const frame = sceneFrameOf(human);

describe('FigurePose', () => {
  it('writes cones in body heights of the clip, with limb and side behind them', () => {
    const pose = new FigurePose(human, frame, standingPose);
    const texture = new ConeTexture(pose.bones.length + 3);
    texture.setBones(pose.bones, 3);
    pose.writePose(standingPose, texture, 3);
    const thigh = Array.from(texture.data.subarray(3 * TEXTURE_STRIDE, 4 * TEXTURE_STRIDE));
    const expected = [0.075, 0.5, 0, 0.043, 0.075, 0.275, 0, 0.031, 0, 0, 0];
    expected.forEach((value, i) => {
      expect(thigh[i]).toBeCloseTo(value, 6);
    });
    expect(texture.data.subarray(0, 3 * TEXTURE_STRIDE).every((value) => value === 0)).toBe(true);
  });

  it('draws a child beside an adult as small and as thin as it is', () => {
    const child = { ...human, body: { ...human.body, height: 1 } };
    const half = standingPose.map((value) => value / 2);
    const pose = new FigurePose(child, frame, half);
    const texture = new ConeTexture(pose.bones.length);
    pose.writePose(half, texture, 0);
    expect(texture.data[1]).toBeCloseTo(0.25, 6);
    expect(texture.data[3]).toBeCloseTo(0.0215, 6);
  });

  it('knows where it stands and how far it reaches', () => {
    const pose = new FigurePose(human, frame, standingPose);
    pose.writePose(
      standingPose.map((value, i) => value + [2, 0, -4][i % 3]),
      new ConeTexture(30),
      0,
    );
    expect(pose.x).toBeCloseTo(1, 6);
    expect(pose.z).toBeCloseTo(-2, 6);
    expect(pose.groundReach).toBeGreaterThan(1);
    expect(pose.groundReach).toBeLessThan(2.5);
  });

  it('asks for more room where another body is long', () => {
    const long = standingPose.map((value, i) => (i % 3 === 0 ? value * 2 : value));
    const excess = (performer: typeof human): number => {
      const pose = new FigurePose(performer, frame, long);
      pose.writePose(long, new ConeTexture(30), 0);
      return pose.excess;
    };
    expect(excess(human)).toBe(0);
    expect(excess(animal)).toBeCloseTo(1.05 - 0.55, 3);
  });

  it('asks for room above and below, once and for good', () => {
    const hanging = standingPose.map((value, i) => (i % 3 === 1 ? value * 2 - 1 : value));
    const pose = new FigurePose(animal, frame, hanging);
    const texture = new ConeTexture(30);
    pose.writePose(hanging, texture, 0);
    pose.writePose(standingPose, texture, 0);
    expect(pose.excessHigh).toBeCloseTo((2 * 1.95 - 1) / 2 - 1, 6);
    expect(pose.excessLow).toBeCloseTo((1 - 2 * 0.02) / 2, 6);
  });

  it('is asked for the middle of the joints where it is not human', () => {
    const aside = standingPose.map((value, i) => (i > 0 && i % 3 === 0 ? value + 1 : value));
    const middle = (performer: typeof human): number => {
      const pose = new FigurePose(performer, frame, aside);
      pose.writePose(aside, new ConeTexture(30), 0);
      return pose.middleX;
    };
    expect(middle(human)).toBe(0);
    expect(middle(animal)).toBeCloseTo((0.5 * (aside.length / 3 - 1)) / (aside.length / 3), 6);
  });
});
