import { describe, expect, it } from 'vitest';
import { flatFigure, FLAT_STRIDE } from './flat-figure';
import { placed } from './placement';
import { animal, human, standingPose } from './test-bodies';

const FRONT = 0;
const FROM_LEFT = Math.PI / 2;

describe('flatFigure', () => {
  it('stands over 0 on the ground and is one body height tall', () => {
    const figure = flatFigure(standingPose, human, FRONT);
    expect(figure.minY).toBeGreaterThan(-0.04);
    expect(figure.minY).toBeLessThan(0.01);
    expect(figure.maxY).toBeGreaterThan(0.95);
    expect(figure.maxY).toBeLessThan(1.05);
    expect(figure.minX).toBeCloseTo(-figure.maxX, 6);
  });

  it('shows the mirror image of a body: what lay at its left lies at its right, as a right limb', () => {
    const raised = standingPose.slice();
    // The left wrist up.
    raised[8 * 3 + 1] += 0.6;
    const stand = { x: 0, z: 0, yawRad: 0 };
    const plain = flatFigure(raised, human, FRONT);
    const mirrored = flatFigure(raised, human, FRONT, placed(stand, stand, true));
    expect(mirrored.minX).toBeCloseTo(-plain.maxX, 6);
    const highest = ({ limbs }: typeof plain): string =>
      limbs.reduce((best, limb) => (top(limb.cones) > top(best.cones) ? limb : best)).side;
    const top = (cones: Float32Array): number => Math.max(...cones.filter((_, i) => i % 3 === 1));
    expect([highest(plain), highest(mirrored)]).toEqual(['left', 'right']);
  });

  it('draws nothing of a body that is farther than 32 bits reach', () => {
    const beyond = standingPose.map(() => 1e308);
    expect(flatFigure(beyond, human, FRONT).limbs).toEqual([]);
  });

  it('keeps the ground line when the body leaps and wanders', () => {
    const standing = flatFigure(standingPose, human, FRONT);
    const leaping = standingPose.map((value, i) => value + [6, 0.5, -4][i % 3]);
    const figure = flatFigure(leaping, human, FRONT);
    expect(figure.minY - standing.minY).toBeCloseTo(0.25 * Math.cos(0.08), 5);
    expect(figure.minX).toBeCloseTo(standing.minX, 5);
  });

  it('shows the left of a body that faces the viewer on the right', () => {
    const figure = flatFigure(standingPose, human, FRONT);
    const left = figure.limbs.find((limb) => limb.side === 'left' && limb.cones[1] > 0.7);
    expect(left?.cones[FLAT_STRIDE]).toBeGreaterThan(0.2);
  });

  it('marks the limbs behind the body as far, from the side only', () => {
    expect(flatFigure(standingPose, human, FRONT).limbs.some((limb) => limb.far)).toBe(false);
    const sides = flatFigure(standingPose, human, FROM_LEFT).limbs.filter((limb) => limb.far);
    expect(sides.map((limb) => limb.side)).toEqual(['right', 'right']);
  });

  it('orders limbs from far to near', () => {
    const { limbs } = flatFigure(standingPose, human, FROM_LEFT);
    expect(limbs[0].side).toBe('right');
    expect(limbs[limbs.length - 1].side).toBe('left');
    expect(limbs.every((limb, i) => i === 0 || limb.depth >= limbs[i - 1].depth)).toBe(true);
  });

  it('draws other bodies as plain bones in one outline, none of them far', () => {
    const { limbs } = flatFigure(standingPose, animal, FROM_LEFT);
    expect(limbs).toHaveLength(1);
    expect(limbs[0].cones.length / FLAT_STRIDE).toBe(animal.skeleton.parents.length - 1);
    expect(limbs.some((limb) => limb.far)).toBe(false);
  });

  it('turns with the yaw: half a turn mirrors the outline', () => {
    const bent = standingPose.slice();
    bent[9 * 3] += 0.4;
    const front = flatFigure(bent, human, FRONT);
    const back = flatFigure(bent, human, Math.PI);
    expect(back.minX).toBeCloseTo(-front.maxX, 5);
    expect(back.maxX).toBeCloseTo(-front.minX, 5);
  });
});
