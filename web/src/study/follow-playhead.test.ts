import { describe, expect, it } from 'vitest';
import { createStore, stillPlayback } from '../app/store';
import { followed, followPlayhead } from './follow-playhead';

const span = { first: 100, last: 300 };
const frameTimeS = 1 / 100;

describe('followed', () => {
  it('scrolls to a paused playhead, wherever it was', () => {
    const move = { before: 600, frame: 610, playing: false, frameTimeS };
    expect(followed(span, 1000, move)).toEqual({ first: 426, last: 626 });
  });

  it('turns the page when the playing one leaves', () => {
    const move = { before: 299, frame: 301, playing: true, frameTimeS };
    expect(followed(span, 1000, move)).toEqual({ first: 285, last: 485 });
  });

  it('lets a person look elsewhere while it plays on', () => {
    const move = { before: 600, frame: 602, playing: true, frameTimeS };
    expect(followed(span, 1000, move)).toBe(span);
  });

  it('goes with a jump during playback', () => {
    const move = { before: 600, frame: 800, playing: true, frameTimeS };
    expect(followed(span, 1000, move)).toEqual({ first: 784, last: 984 });
  });
});

describe('followPlayhead', () => {
  it('leaves the whole clip whole', () => {
    const store = createStore();
    const stop = followPlayhead(store);
    store.playback.value = { ...stillPlayback, frame: 500 };
    expect(store.zoom.value).toBeNull();
    stop();
  });
});
