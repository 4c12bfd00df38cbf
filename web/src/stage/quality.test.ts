import { describe, expect, it } from 'vitest';
import { Quality } from './quality';

function run(quality: Quality, intervalMs: number, frames: number): number {
  let changes = 0;
  for (let i = 0; i < frames; i++) if (quality.frame(intervalMs)) changes++;
  return changes;
}

describe('Quality', () => {
  it('steps down when frames stay slow, not for one slow frame', () => {
    const quality = new Quality();
    run(quality, 100, 10);
    run(quality, 16, 1);
    run(quality, 100, 10);
    expect(quality.reduced).toBe(false);
    run(quality, 100, 10);
    expect(quality.reduced).toBe(true);
  });

  it('steps up after a long quick run, a longer one after every step down', () => {
    const quality = new Quality();
    expect(run(quality, 40, 30)).toBe(1);
    expect(run(quality, 16, 300)).toBe(1);
    expect(quality.reduced).toBe(false);
    expect(run(quality, 40, 30)).toBe(1);
    expect(run(quality, 16, 700)).toBe(0);
    expect(run(quality, 16, 100)).toBe(1);
    expect(quality.reduced).toBe(false);
  });
});
