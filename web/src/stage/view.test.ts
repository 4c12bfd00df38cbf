import { describe, expect, it } from 'vitest';
import { eased, framing, mixViews, presetView, shortestTurn, type View } from './view';

const alone = { x: 0, z: 0, reach: 0, above: 0, below: 0, ghosts: 0 };
const yaws = { frontYawRad: 0.4, sideYawRad: 2.1 };

describe('presetView', () => {
  it('looks at the figure from the yaw of the preset', () => {
    expect(presetView('front', yaws, 2, { ...alone, x: 3, z: -1 })).toMatchObject({
      yawRad: 0.4,
      targetX: 3,
      targetZ: -1,
    });
    expect(presetView('side', yaws, 2, alone).yawRad).toBe(2.1);
    expect(presetView('top', yaws, 2, alone).elevationRad).toBeGreaterThan(1.5);
  });

  it('frames a body height and a third, or more where the stage is narrow', () => {
    const wide = presetView('side', yaws, 2, alone);
    const halfHeight = wide.distance * Math.tan((23 / 360) * Math.PI);
    expect(halfHeight).toBeCloseTo(0.67, 9);
    const narrow = presetView('side', yaws, 0.5, alone);
    expect(narrow.distance * Math.tan((23 / 360) * Math.PI) * 0.5).toBeCloseTo(0.6, 9);
  });
});

describe('presetView of several figures', () => {
  it('steps back until the outermost is in the picture', () => {
    const near = presetView('side', yaws, 2, alone);
    expect(presetView('side', yaws, 2, { ...alone, reach: 0.3 }).distance).toBeCloseTo(
      near.distance + 0.3,
      9,
    );
    const wide = presetView('side', yaws, 1, { ...alone, reach: 1 });
    expect((wide.distance - 1) * Math.tan((23 / 360) * Math.PI)).toBeCloseTo(1.6, 9);
  });
});

describe('framing', () => {
  it('shows as many times as much as is asked for, wherever ghosts are', () => {
    const half = (room: number | null, ghosts: number): number =>
      framing(2, { ...alone, ghosts }, 0, room).distance * Math.tan((23 / 360) * Math.PI);
    expect([half(1.25, 0), half(1.25, 9)].map((value) => value / half(null, 0))).toEqual([
      expect.closeTo(1.25, 9),
      expect.closeTo(1.25, 9),
    ]);
  });

  it('takes in what is above and below a standing human', () => {
    const { distance, targetY } = framing(2, { ...alone, above: 0.8, below: 0.2 });
    const halfHeight = distance * Math.tan((23 / 360) * Math.PI);
    expect(targetY + halfHeight).toBeCloseTo(1.21 + 0.8, 9);
    expect(targetY - halfHeight).toBeCloseTo(-0.13 - 0.2, 9);
  });
});

it('headroom: the figure keeps its place below what stands over the stage', () => {
  const { distance, targetY } = framing(2, alone, 0.1);
  const half = distance * Math.tan((23 / 360) * Math.PI);
  const top = targetY + half;
  expect(top - 0.1 * 2 * half).toBeCloseTo(1.21, 9);
  expect(targetY - half).toBeCloseTo(-0.13, 9);
});

describe('framing of ghosts', () => {
  const half = (aspect: number, ghosts: number): number =>
    framing(aspect, { ...alone, ghosts }).distance * Math.tan((23 / 360) * Math.PI);

  it('lets them be where there is room, and makes room where there is none', () => {
    expect(half(2.5, 1)).toBeCloseTo(0.67, 9);
    expect(half(1.2, 0.5)).toBeCloseTo(1 / 1.2, 9);
  });

  it('does not make the figure small for a ghost far away', () => {
    expect(half(2, 30)).toBeCloseTo(0.67 * 1.5, 9);
  });
});

describe('mixViews', () => {
  const from: View = {
    yawRad: 3,
    elevationRad: 0,
    distance: 2,
    targetX: 0,
    targetY: 0,
    targetZ: 0,
  };
  const to: View = { yawRad: -3, elevationRad: 1, distance: 4, targetX: 1, targetY: 2, targetZ: 3 };

  it('turns the shorter way round', () => {
    const out = { ...from };
    mixViews(from, to, 0.5, out);
    expect(Math.abs(out.yawRad)).toBeCloseTo(Math.PI, 9);
    expect(out).toMatchObject({
      elevationRad: 0.5,
      distance: 3,
      targetX: 0.5,
      targetY: 1,
      targetZ: 1.5,
    });
  });

  it('begins and ends at its ends', () => {
    const out = { ...from };
    mixViews(from, to, 0, out);
    expect(out).toEqual(from);
    mixViews(from, to, 1, out);
    expect(shortestTurn(out.yawRad, to.yawRad)).toBeCloseTo(0, 9);
    expect(out.distance).toBe(4);
  });
});

describe('shortestTurn', () => {
  it('is never more than half a turn', () => {
    for (let from = -10; from < 10; from += 0.37) {
      for (let to = -10; to < 10; to += 0.41) {
        const turn = shortestTurn(from, to);
        expect(Math.abs(turn)).toBeLessThanOrEqual(Math.PI);
        expect(Math.cos(from + turn - to)).toBeCloseTo(1, 9);
      }
    }
  });
});

describe('eased', () => {
  it('runs from 0 to 1, quick at first', () => {
    expect([eased(-1), eased(0), eased(1), eased(2)]).toEqual([0, 0, 1, 1]);
    expect(eased(0.25)).toBeGreaterThan(0.5);
  });
});
