import { signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import type { Comparer, Warping } from '../engine/comparison-types';
import type { PairClip } from './pair-clips';
import { followWarpings, type WarpingWish } from './warpings';

const clip = (id: number): PairClip => ({ id, result: { frames: id } }) as unknown as PairClip;
const [a, b, c] = [clip(1), clip(2), clip(3)];

/** A comparer that warps when it is told to. */
function slowComparer() {
  const asked: string[] = [];
  const open: {
    finish: () => void;
    fail: (error: Error) => void;
    progress: (done: number) => void;
  }[] = [];
  const warp: Comparer['warp'] = (one, other, { mirrorB }, work = {}) => {
    const { signal: abort, onProgress } = work;
    asked.push(`${one} ${other}${mirrorB ? ' mirrored' : ''}`);
    return new Promise<Warping>((resolve, reject) => {
      abort?.addEventListener('abort', () => reject(new Error('aborted')));
      open.push({
        finish: () => resolve({ distance: other } as Warping),
        fail: reject,
        progress: (done) => onProgress?.({ stage: 'analysing', done }),
      });
    });
  };
  const settle = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));
  return { comparer: { warp }, asked, open, settle };
}

const follow = (wish: WarpingWish) => {
  const slow = slowComparer();
  const wanted = signal<WarpingWish | null>(wish);
  return { ...slow, wanted, warpings: followWarpings(slow.comparer, wanted) };
};

describe('warpings', () => {
  it('come one after the other, B first', async () => {
    const { asked, open, settle, warpings } = follow({ clips: [a, b, c], mirrorB: false });
    expect(asked).toEqual(['1 2']);
    open[0].progress(0.4);
    expect(warpings.progress.value).toBe(0.4);
    open[0].finish();
    await settle();
    expect(asked).toEqual(['1 2', '1 3']);
    expect([...warpings.found.value.keys()]).toEqual([2]);
    expect(warpings.progress.value).toBeNull();
    expect(warpings.underWay.value).toBe(true);
    open[1].finish();
    await settle();
    expect(warpings.underWay.value).toBe(false);
  });

  it('stay when a clip comes, and go when A or the mirror changes', async () => {
    const { asked, open, settle, warpings, wanted } = follow({ clips: [a, b], mirrorB: false });
    open[0].finish();
    await settle();
    const { value } = warpings.found;
    wanted.value = { clips: [a, b, c], mirrorB: false };
    expect(warpings.found.value).toBe(value);
    open[1].finish();
    await settle();
    expect(asked).toEqual(['1 2', '1 3']);
    wanted.value = { clips: [a, b, c], mirrorB: true };
    expect([...warpings.found.value.keys()]).toEqual([3]);
    expect(asked.at(-1)).toBe('1 2 mirrored');
    wanted.value = { clips: [b, a], mirrorB: false };
    expect(warpings.found.value.size).toBe(0);
    expect(asked.at(-1)).toBe('2 1');
  });

  it('can be given up and wanted again', async () => {
    const { asked, open, settle, warpings } = follow({ clips: [a, b], mirrorB: false });
    warpings.cancel();
    await settle();
    expect(warpings.cancelled.value).toBe(true);
    expect([warpings.progress.value, warpings.failure.value]).toEqual([null, null]);
    expect(warpings.underWay.value).toBe(false);
    warpings.warp();
    expect(warpings.cancelled.value).toBe(false);
    expect(asked.length).toBe(2);
    open[1].finish();
    await settle();
    expect(warpings.found.value.size).toBe(1);
  });

  it('tell why B cannot be warped, not why others cannot', async () => {
    const { open, settle, warpings } = follow({ clips: [a, b, c], mirrorB: false });
    const why = new Error('too long');
    open[0].fail(why);
    await settle();
    expect(warpings.failure.value).toBe(why);
    open[1].fail(new Error('other'));
    await settle();
    expect(warpings.failure.value).toBe(why);
  });
});
