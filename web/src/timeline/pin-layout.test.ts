import { describe, expect, it } from 'vitest';
import { Axis } from './axis';
import { layoutPins } from './pin-layout';

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
});
