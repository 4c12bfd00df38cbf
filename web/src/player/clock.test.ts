import { describe, expect, it } from 'vitest';
import { Clock, frameAt } from './clock';

const clip = { frames: 101, frameTimeS: 1 / 120 };

describe('frameAt', () => {
  it('gives every frame back at its own time, whatever the rounding', () => {
    for (const frameTimeS of [1 / 120, 1 / 30, 0.0083333, 1 / 23.976, 0.033]) {
      for (let frame = 0; frame < 5000; frame++) {
        expect(frameAt(frame * frameTimeS, frameTimeS, 5000)).toBe(frame);
      }
    }
  });

  it('holds a frame until the next begins, and stays in the clip', () => {
    expect(frameAt(0.0999, 0.1, 10)).toBe(0);
    expect(frameAt(0.1, 0.1, 10)).toBe(1);
    expect(frameAt(99, 0.1, 10)).toBe(9);
    expect(frameAt(-1, 0.1, 10)).toBe(0);
    expect(frameAt(1, 0.1, 0)).toBe(0);
  });
});

describe('Clock', () => {
  it('lasts last frame × frame time and stops on the last frame', () => {
    const clock = new Clock(clip);
    expect(clock.durationS).toBeCloseTo(100 / 120, 12);
    clock.play();
    clock.advance(10);
    expect(clock.playing).toBe(false);
    expect(clock.frame).toBe(100);
  });

  it('plays from the start again once it has ended', () => {
    const clock = new Clock(clip);
    clock.seekFrame(100);
    clock.play();
    expect(clock.frame).toBe(0);
  });

  it('does not move while paused, nor backwards', () => {
    const clock = new Clock(clip);
    clock.advance(0.1);
    expect(clock.timeS).toBe(0);
    clock.play();
    clock.advance(-1);
    clock.advance(Number.NaN);
    expect(clock.timeS).toBe(0);
  });

  it('keeps speed between 0.1 and 4 and plays by it', () => {
    const clock = new Clock(clip);
    clock.setSpeed(9);
    expect(clock.speed).toBe(4);
    clock.setSpeed(0);
    expect(clock.speed).toBe(0.1);
    clock.setSpeed(0.5);
    clock.play();
    clock.advance(0.1);
    expect(clock.timeS).toBeCloseTo(0.05, 12);
  });

  it('steps speed up and down and ends at the ends', () => {
    const clock = new Clock(clip);
    clock.stepSpeed(1);
    expect(clock.speed).toBe(1.5);
    clock.stepSpeed(-1);
    clock.stepSpeed(-1);
    expect(clock.speed).toBe(0.75);
    for (let i = 0; i < 20; i++) clock.stepSpeed(-1);
    expect(clock.speed).toBe(0.1);
  });

  it('loops between A and B, carrying what is over into the next round', () => {
    const clock = new Clock(clip);
    clock.setLoop({ a: 60, b: 36 });
    expect(clock.loopRange).toEqual({ a: 36, b: 60 });
    clock.seekFrame(59);
    clock.play();
    clock.advance(3 / 120);
    expect(clock.playing).toBe(true);
    expect(clock.frame).toBe(38);
  });

  it('plays into a loop from before it, and returns to A from behind it', () => {
    const clock = new Clock(clip);
    clock.setLoop({ a: 36, b: 60 });
    clock.seekFrame(10);
    clock.play();
    clock.advance(1 / 120);
    expect(clock.frame).toBe(11);
    clock.pause();
    clock.seekFrame(80);
    clock.play();
    expect(clock.frame).toBe(36);
  });

  it('returns to A itself from behind the loop, also where it is led while playing', () => {
    const clock = new Clock(clip);
    clock.setLoop({ a: 36, b: 60 });
    clock.seekFrame(50);
    clock.play();
    clock.seekFrame(95);
    clock.advance(1 / 120);
    expect(clock.frame).toBe(36);
  });

  it('never drifts: after a thousand rounds a loop is where it should be', () => {
    const clock = new Clock(clip);
    clock.setLoop({ a: 30, b: 60 });
    clock.seekFrame(30);
    clock.play();
    for (let tick = 0; tick < 15_006; tick++) clock.advance(1 / 60);
    expect(clock.timeS).toBeCloseTo(0.35, 9);
  });

  it('keeps the time when the speed changes', () => {
    const clock = new Clock(clip);
    clock.play();
    clock.advance(0.1);
    clock.setSpeed(4);
    expect(clock.timeS).toBeCloseTo(0.1, 12);
    clock.advance(0.1);
    expect(clock.timeS).toBeCloseTo(0.5, 12);
  });

  it('loops the whole clip without A and B, and stays on a loop of one frame', () => {
    const clock = new Clock(clip);
    clock.setLooping(true);
    clock.seekFrame(99);
    clock.play();
    clock.advance(2 / 120);
    expect(clock.frame).toBe(1);
    clock.setLoop({ a: 7, b: 7 });
    clock.seekFrame(9);
    clock.advance(0.01);
    expect(clock.frame).toBe(7);
  });

  it('sets A and B at the current frame and never crosses them', () => {
    const clock = new Clock(clip);
    clock.seekFrame(40);
    clock.setLoopStart();
    expect(clock.loopRange).toEqual({ a: 40, b: 100 });
    clock.seekFrame(20);
    clock.setLoopEnd();
    expect(clock.loopRange).toEqual({ a: 0, b: 20 });
    clock.seekFrame(50);
    clock.setLoopStart();
    expect(clock.loopRange).toEqual({ a: 50, b: 100 });
  });

  it('keeps A and B while the loop is off', () => {
    const clock = new Clock(clip);
    clock.setLoop({ a: 36, b: 60 });
    clock.setLooping(false);
    clock.seekFrame(59);
    clock.play();
    clock.advance(3 / 120);
    expect(clock.frame).toBe(62);
    expect(clock.loopRange).toEqual({ a: 36, b: 60 });
  });

  it('steps from within a frame to the times of whole frames', () => {
    const clock = new Clock(clip);
    clock.seekTime(10.4 / 120);
    clock.step(1);
    expect(clock.timeS).toBeCloseTo(11 / 120, 12);
    clock.step(-100);
    expect(clock.frame).toBe(0);
  });

  it('tells of changes only, until told not to', () => {
    const clock = new Clock(clip);
    let calls = 0;
    const end = clock.onChange(() => calls++);
    clock.seekFrame(0);
    clock.setSpeed(1);
    clock.pause();
    expect(calls).toBe(0);
    clock.seekFrame(3);
    expect(calls).toBe(1);
    end();
    clock.seekFrame(4);
    expect(calls).toBe(1);
  });

  it('does not play a clip of one frame', () => {
    const clock = new Clock({ frames: 1, frameTimeS: 1 / 30 });
    clock.play();
    expect(clock.playing).toBe(false);
    expect(clock.durationS).toBe(0);
  });
});
