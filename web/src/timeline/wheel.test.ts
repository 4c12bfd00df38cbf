import { describe, expect, it } from 'vitest';
import { Touches } from './touches';
import { turnOf, type WheelTurn } from './wheel';

const still: WheelTurn = {
  ctrlKey: false,
  metaKey: false,
  shiftKey: false,
  deltaX: 0,
  deltaY: 0,
  deltaMode: 0,
};

describe('the wheel', () => {
  it('zooms with Ctrl or Meta, in by turning away', () => {
    const inward = turnOf({ ...still, ctrlKey: true, deltaY: -100 });
    const outward = turnOf({ ...still, metaKey: true, deltaY: 100 });
    expect(inward).toEqual({ factor: Math.exp(0.3) });
    expect(outward).toEqual({ factor: Math.exp(-0.3) });
  });

  it('pans sideways, or with Shift, by lines where it says lines', () => {
    expect(turnOf({ ...still, deltaX: 30, deltaY: 5 })).toEqual({ pan: 30 });
    expect(turnOf({ ...still, shiftKey: true, deltaY: 3, deltaMode: 1 })).toEqual({ pan: 48 });
  });

  it('leaves up and down to the page', () => {
    expect(turnOf({ ...still, deltaX: 5, deltaY: 30 })).toBeNull();
  });
});

describe('two fingers', () => {
  it('spread the axis about the one that stays', () => {
    const touches = new Touches();
    touches.put(1, 100);
    expect(touches.move(1, 110)).toBeNull();
    touches.put(2, 210);
    expect(touches.move(2, 310)).toEqual({ factor: 2, about: 110 });
    expect(touches.move(1, 210)).toEqual({ factor: 0.5, about: 310 });
    touches.lift(1);
    expect(touches.count).toBe(1);
  });

  it('do not pass each other', () => {
    const touches = new Touches();
    touches.put(1, 100);
    touches.put(2, 140);
    expect(touches.move(2, 90)).toBeNull();
  });
});
