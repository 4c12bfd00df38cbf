import { describe, expect, it } from 'vitest';
import { Axis } from './axis';
import { brushed, brushPart, brushWindow, spanAfterKey } from './brush';

/** One pixel a frame, frame 0 at pixel 10. */
const axis = new Axis(1028, 1000);
const span = { first: 200, last: 400 };

describe('brushPart', () => {
  const window = brushWindow(span, axis, 6);

  it('tells the window from its edges and from what is outside', () => {
    const parts = [100, 206, 214, 300, 408, 500].map((x) => brushPart(window, x, false));
    expect(parts).toEqual(['outside', 'first', 'first', 'window', 'last', 'outside']);
  });

  it('begins a new window in one that shows everything', () => {
    expect(brushPart(brushWindow({ first: 0, last: 1000 }, axis, 6), 500, true)).toBe('outside');
  });

  it('gives a narrow window no edges, but enough width to grasp', () => {
    const narrow = brushWindow({ first: 500, last: 501 }, axis, 10);
    expect(narrow.last - narrow.first).toBe(10);
    expect(brushPart(narrow, 507, false)).toBe('window');
  });
});

describe('brushed', () => {
  it('moves the window within the clip', () => {
    expect(brushed('window', span, axis, 300, 350)).toEqual({ first: 250, last: 450 });
    expect(brushed('window', span, axis, 300, 2000)).toEqual({ first: 800, last: 1000 });
  });

  it('moves an edge alone, and past the other', () => {
    expect(brushed('first', span, axis, 210, 260)).toEqual({ first: 250, last: 400 });
    expect(brushed('last', span, axis, 410, 160)).toEqual({ first: 150, last: 200 });
    expect(brushed('last', span, axis, 410, 5000)).toEqual({ first: 200, last: 1000 });
  });

  it('makes a new window in either direction', () => {
    expect(brushed('outside', span, axis, 610, 510)).toEqual({ first: 500, last: 600 });
  });
});

describe('spanAfterKey', () => {
  it('moves, resizes, zooms, ends and shows all', () => {
    const after = (key: string, shift = false) => spanAfterKey(key, shift, span, 1000);
    expect(after('ArrowRight')).toEqual({ first: 220, last: 420 });
    expect(after('ArrowLeft')).toEqual({ first: 180, last: 380 });
    expect(after('ArrowRight', true)).toEqual({ first: 200, last: 420 });
    expect(after('ArrowLeft', true)).toEqual({ first: 200, last: 380 });
    expect(after('Home')).toEqual({ first: 0, last: 200 });
    expect(after('End')).toEqual({ first: 800, last: 1000 });
    expect(after('+')).toEqual({ first: 250, last: 350 });
    expect(after('-')).toEqual({ first: 100, last: 500 });
    expect(after('0')).toBeNull();
    expect(after('k')).toBeUndefined();
  });
});
