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

  it('shows a part of the clip over its whole width', () => {
    const axis = new Axis(128, 1000, { first: 200, last: 300 });
    expect(axis.x(200)).toBe(10);
    expect(axis.x(300)).toBe(110);
    expect(axis.frameAt(60)).toBe(250);
    expect(axis.frameAt(-5000)).toBe(0);
  });

  it('bears a clip of one frame', () => {
    expect(new Axis(760, 0).frameAt(300)).toBe(0);
  });
});
