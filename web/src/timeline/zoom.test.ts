import { describe, expect, it } from 'vitest';
import { fitted, paged, panned, revealed, SHORTEST_SPAN, wholeSpan, zoomed } from './zoom';

const last = 1000;
const whole = wholeSpan(last);

describe('zoomed', () => {
  it('keeps the place that it zooms about', () => {
    const span = zoomed(whole, last, 4, 200)!;
    expect(span).toEqual({ first: 150, last: 400 });
    expect((200 - span.first) / (span.last - span.first)).toBeCloseTo(0.2, 12);
  });

  it('comes back to the whole clip, and never beyond it', () => {
    const near = zoomed(whole, last, 4, 1000)!;
    expect(near.last).toBe(last);
    expect(zoomed(near, last, 1 / 4, 900)).toBeNull();
    expect(zoomed(whole, last, 1 / 2, 500)).toBeNull();
  });

  it('ends at the shortest span', () => {
    const span = zoomed(whole, last, 1e6, 500)!;
    expect(span.last - span.first).toBeCloseTo(SHORTEST_SPAN, 9);
    expect(zoomed(span, last, 2, 500)).toEqual(span);
  });

  it('brings a place outside the span to its middle', () => {
    expect(zoomed({ first: 0, last: 100 }, last, 2, 500)).toEqual({ first: 475, last: 525 });
  });

  it('shows a clip that is shorter than the shortest span whole', () => {
    for (const short of [0, 1, SHORTEST_SPAN]) {
      expect(zoomed(wholeSpan(short), short, 2, 0)).toBeNull();
    }
  });
});

describe('panned', () => {
  it('keeps the length and stays within the clip', () => {
    const span = { first: 100, last: 300 };
    expect(panned(span, last, 50)).toEqual({ first: 150, last: 350 });
    expect(panned(span, last, -500)).toEqual({ first: 0, last: 200 });
    expect(panned(span, last, 5000)).toEqual({ first: 800, last: 1000 });
  });
});

describe('revealed', () => {
  const span = { first: 100, last: 300 };

  it('leaves a span alone that shows the frame', () => {
    for (const frame of [100, 200, 300]) expect(revealed(span, last, frame)).toEqual(span);
  });

  it('scrolls just far enough, with a little air', () => {
    expect(revealed(span, last, 400)).toEqual({ first: 216, last: 416 });
    expect(revealed(span, last, 90)).toEqual({ first: 74, last: 274 });
    expect(revealed(span, last, 0)).toEqual({ first: 0, last: 200 });
  });
});

describe('paged', () => {
  it('turns over when the frame has left, with the frame near the beginning', () => {
    const span = { first: 100, last: 300 };
    expect(paged(span, last, 300)).toEqual(span);
    expect(paged(span, last, 301)).toEqual({ first: 285, last: 485 });
    expect(paged(span, last, 5)).toEqual({ first: 0, last: 200 });
  });
});

describe('fitted', () => {
  it('brings any span into the clip', () => {
    expect(fitted({ first: -50, last: 50 }, last)).toEqual({ first: 0, last: 100 });
    expect(fitted({ first: 990, last: 995 }, last)).toEqual({ first: 980, last: 1000 });
    expect(fitted({ first: -1, last: 2000 }, last)).toBeNull();
  });
});
