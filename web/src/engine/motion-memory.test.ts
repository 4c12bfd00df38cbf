import { describe, expect, it } from 'vitest';
import { MotionMemory } from './motion-memory';

describe('motion memory', () => {
  it('drops the motions used longest ago, never the one in use or on the stage', () => {
    const memory = new MotionMemory(100);
    expect(memory.used(1, 40)).toEqual([]);
    expect(memory.used(2, 40)).toEqual([]);
    memory.keep(1);
    expect(memory.used(3, 40)).toEqual([2]);
    expect(memory.used(4, 200)).toEqual([3]);
    expect(memory.total()).toBe(240);
    memory.keep(null);
    expect(memory.used(5, 10)).toEqual([1, 4]);
  });

  it('counts a clip once, with its last size', () => {
    const memory = new MotionMemory(100);
    memory.used(1, 60);
    memory.used(1, 80);
    expect(memory.total()).toBe(80);
    memory.used(1, 0);
    expect(memory.total()).toBe(0);
    memory.used(2, 90);
    memory.forget(2);
    expect(memory.used(3, 90)).toEqual([]);
  });
});
