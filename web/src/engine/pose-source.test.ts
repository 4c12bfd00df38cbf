import { describe, expect, it, vi } from 'vitest';
import { createPoseSource } from './pose-source';

/** An engine whose poses hold their frame, and which answers when told to. */
function fakeEngine() {
  const waiting: (() => void)[] = [];
  const poseRange = vi.fn(
    (_clip: number, _performer: number, first: number, count: number) =>
      new Promise<Float32Array>((resolve) => {
        const poses = Float32Array.from({ length: count * 6 }, (_, i) => first + Math.floor(i / 6));
        waiting.push(() => resolve(poses));
      }),
  );
  const answer = async () => {
    waiting.splice(0).forEach((settle) => settle());
    await new Promise((resolve) => setTimeout(resolve, 0));
  };
  return { engine: { poseRange }, answer };
}

const shape = { jointCount: 2, frames: 25 };

describe('pose source', () => {
  it('gives a frame once its chunk has arrived, and asks for a chunk only once', async () => {
    const { engine, answer } = fakeEngine();
    const source = createPoseSource(engine, 1, 0, shape, { chunkFrames: 10 });
    const arrived = vi.fn();
    source.onArrive(arrived);
    expect(source.read(13)).toBeNull();
    expect(source.read(14)).toBeNull();
    expect(engine.poseRange).toHaveBeenCalledTimes(1);
    expect(engine.poseRange.mock.calls[0]?.slice(0, 4)).toEqual([1, 0, 10, 10]);
    await answer();
    expect(arrived).toHaveBeenCalledTimes(1);
    expect([...(source.read(13) ?? [])]).toEqual([13, 13, 13, 13, 13, 13]);
    expect(source.read(13)).toBe(source.read(13));
  });

  it('has the rest pose of a clip without frames', async () => {
    const { engine, answer } = fakeEngine();
    const source = createPoseSource(engine, 1, 0, { jointCount: 2, frames: 0 });
    expect(source.frames).toBe(1);
    expect(source.read(0)).toBeNull();
    expect(engine.poseRange.mock.calls[0]?.slice(0, 4)).toEqual([1, 0, 0, 1]);
    await answer();
    expect(source.read(0)).toHaveLength(6);
  });

  it('knows no frame outside of the clip', () => {
    const { engine } = fakeEngine();
    const source = createPoseSource(engine, 1, 0, shape, { chunkFrames: 10 });
    for (const frame of [-1, 25, 0.5, Number.NaN]) expect(source.read(frame)).toBeNull();
    expect(engine.poseRange).not.toHaveBeenCalled();
  });

  it('fetches ahead in the direction of play, as far as the clip goes', () => {
    const { engine } = fakeEngine();
    const firsts = () => engine.poseRange.mock.calls.map((call) => [call[2], call[3]]);
    const source = createPoseSource(engine, 1, 0, shape, { chunkFrames: 10, chunksAhead: 2 });
    source.prefetch(12, 1);
    expect(firsts()).toEqual([
      [10, 10],
      [20, 5],
    ]);
    source.prefetch(12, -1);
    expect(firsts().slice(2)).toEqual([[0, 10]]);
  });

  it('forgets the chunks that were used longest ago', async () => {
    const { engine, answer } = fakeEngine();
    const source = createPoseSource(
      engine,
      1,
      0,
      { jointCount: 2, frames: 1000 },
      {
        chunkFrames: 10,
        chunksAhead: 0,
        maximumBytes: 3 * 10 * 6 * 4,
      },
    );
    for (const frame of [0, 10, 20, 30]) {
      source.read(frame);
      await answer();
      expect(source.read(frame)).not.toBeNull();
    }
    expect(source.read(10)).not.toBeNull();
    expect(source.read(0)).toBeNull();
  });

  it('follows the latest wish when many are made', async () => {
    const { engine, answer } = fakeEngine();
    const source = createPoseSource(
      engine,
      1,
      0,
      { jointCount: 2, frames: 1000 },
      { chunkFrames: 10 },
    );
    for (let frame = 0; frame < 1000; frame += 10) source.read(frame);
    expect(engine.poseRange).toHaveBeenCalledTimes(4);
    await answer();
    expect(engine.poseRange).toHaveBeenCalledTimes(5);
    expect(engine.poseRange.mock.calls[4]?.[2]).toBe(990);
  });

  it('is silent after it was destroyed', async () => {
    const { engine, answer } = fakeEngine();
    const source = createPoseSource(engine, 1, 0, shape, { chunkFrames: 10 });
    const arrived = vi.fn();
    source.onArrive(arrived);
    source.read(0);
    source.destroy();
    await answer();
    expect(arrived).not.toHaveBeenCalled();
    expect(source.read(0)).toBeNull();
  });

  it('tells of a failure, and tries again a second later, however often it is read', async () => {
    vi.useFakeTimers();
    const poseRange = vi.fn(() => Promise.reject(new Error('changed on disk')));
    const onError = vi.fn();
    const source = createPoseSource({ poseRange }, 1, 0, shape, { chunkFrames: 10, onError });
    for (let read = 0; read < 50; read += 1) {
      source.read(0);
      await vi.advanceTimersByTimeAsync(16);
    }
    expect(poseRange).toHaveBeenCalledTimes(1);
    expect(onError).toHaveBeenCalledTimes(1);
    await vi.advanceTimersByTimeAsync(1000);
    source.read(0);
    expect(poseRange).toHaveBeenCalledTimes(2);
    vi.useRealTimers();
  });

  it('tells of poses of a wrong length with the numbers', async () => {
    const poseRange = () => Promise.resolve(new Float32Array(5));
    const onError = vi.fn();
    const source = createPoseSource({ poseRange }, 1, 0, shape, { chunkFrames: 10, onError });
    source.read(0);
    await new Promise((resolve) => setTimeout(resolve, 0));
    const [error] = onError.mock.calls[0] as [RangeError];
    expect(error.message).toBe('10 frames of 6 values expected, 5 values came');
  });
});
