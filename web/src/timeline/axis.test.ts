import { describe, expect, it } from 'vitest';
import { Axis } from './axis';

describe('Axis', () => {
  it('gives back each frame at its own pixel', () => {
    const axis = new Axis(760, 316);
    for (const frame of [0, 1, 158, 316]) expect(axis.frameAt(axis.x(frame))).toBe(frame);
  });

  it('stays within the clip beyond its ends', () => {
    const axis = new Axis(760, 316);
    expect(axis.frameAt(-50)).toBe(0);
    expect(axis.frameAt(5000)).toBe(316);
  });

  it('bears a clip of one frame', () => {
    expect(new Axis(760, 0).frameAt(300)).toBe(0);
  });
});
