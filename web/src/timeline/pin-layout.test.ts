import { describe, expect, it } from 'vitest';
import { Axis } from './axis';
import { layoutPins, pinWidth } from './pin-layout';

describe('layoutPins', () => {
  const axis = new Axis(128, 100);

  it('keeps distant keyposes apart and groups near ones', () => {
    const pins = layoutPins([5, 50, 55, 60, 90], axis);
    expect(pins.map((pin) => [pin.first, pin.last])).toEqual([
      [0, 0],
      [1, 3],
      [4, 4],
    ]);
    expect(pins[1].x).toBe(axis.x(55));
  });

  it('is empty without keyposes', () => {
    expect(layoutPins([], axis)).toEqual([]);
  });

  it('cuts a crowd into lozenges side by side, each keypose under one of them', () => {
    const frames = Array.from({ length: 5000 }, (_, n) => n * 86);
    const pins = layoutPins(frames, new Axis(800, 432_000));
    expect(pins.length).toBeGreaterThan(12);
    expect(pins.map(({ first }) => first)).toEqual([
      0,
      ...pins.slice(0, -1).map((p) => p.last + 1),
    ]);
    expect(pins.at(-1)!.last).toBe(4999);
  });

  it('lets no lozenge overlap its neighbour', () => {
    for (let seed = 1; seed < 40; seed++) {
      let frame = 0;
      const frames = Array.from({ length: 300 }, (_, n) => (frame += 1 + ((n * seed * 7919) % 23)));
      const pins = layoutPins(frames, new Axis(900, frame));
      pins.slice(1).forEach((pin, index) => {
        const before = pins[index];
        const [a, b] = [before.last - before.first + 1, pin.last - pin.first + 1];
        const least = a === 1 && b === 1 ? 12 : (pinWidth(a) + pinWidth(b)) / 2;
        expect(pin.x - before.x).toBeGreaterThanOrEqual(least - 1e-9);
      });
    }
  });

  it('groups alike wherever the axis stands', () => {
    const frames = [5, 50, 55, 60, 90, 91, 140];
    const groups = (first: number): number[] =>
      layoutPins(frames, new Axis(128, 200, { first, last: first + 100 })).map((pin) => pin.first);
    expect(groups(0)).toEqual(groups(33));
  });
});
