import { describe, expect, it } from 'vitest';
import { fitFigure, limbPath } from './draw-flat-figure';
import { flatFigure } from './flat-figure';
import { human, standingPose } from './test-bodies';

const figure = flatFigure(standingPose, human, 0);

describe('fitFigure', () => {
  it('fills the box to its padding in the tighter direction and centres the outline', () => {
    const { scale, x, groundY } = fitFigure(figure, 36, 36, 3);
    const width = scale * (figure.maxX - figure.minX);
    const height = scale * (figure.maxY - figure.minY);
    expect(Math.max(width, height)).toBeCloseTo(30, 6);
    expect(x + (scale * (figure.minX + figure.maxX)) / 2).toBeCloseTo(18, 6);
    expect(groundY - (scale * (figure.minY + figure.maxY)) / 2).toBeCloseTo(18, 6);
  });

  it('does not blow up small figures beyond a scale', () => {
    expect(fitFigure(figure, 1000, 1000, 3, 50).scale).toBe(50);
  });
});

describe('limbPath', () => {
  it('has one closed outline for each cone, within the figure’s extent', () => {
    const place = { scale: 100, x: 200, groundY: 300 };
    for (const limb of figure.limbs) {
      const path = limbPath(limb, place);
      expect(path.match(/M/g)?.length).toBe(limb.cones.length / 6);
      expect(path.match(/Z/g)?.length).toBe(limb.cones.length / 6);
      expect(path).not.toMatch(/NaN|Infinity/);
    }
  });

  it('puts the ground at groundY and up upward', () => {
    const head = limbPath(figure.limbs[figure.limbs.length - 1], { scale: 100, x: 0, groundY: 0 });
    const heights = [...head.matchAll(/[ML]\S+ (\S+?)(?=[A-Z])/g)].map((match) => Number(match[1]));
    expect(heights.length).toBeGreaterThan(0);
    expect(Math.max(...heights)).toBeLessThan(0.1 * 100);
  });
});
