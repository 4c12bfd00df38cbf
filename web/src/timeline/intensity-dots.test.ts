import { describe, expect, it } from 'vitest';
import { DotGrid, intensityRadius, intensityY } from './intensity-dots';

const row = { top: 176, height: 48, folded: false };

describe('dots of intensity', () => {
  it('stand higher and are larger the more intense they are, within their row', () => {
    const [low, high] = [0, 30].map((intensity) => intensityY(row, intensity, 30));
    expect(low).toBe(219);
    expect(high - intensityRadius(row, 30, 30)).toBeGreaterThan(row.top);
    expect(intensityRadius(row, 30, 30)).toBeGreaterThan(intensityRadius(row, 5, 30));
  });

  it('stay within a folded row, and where there is no intensity at all', () => {
    const folded = { top: 100, height: 22, folded: true };
    const top = intensityY(folded, 30, 30) - intensityRadius(folded, 30, 30);
    expect(top).toBeGreaterThanOrEqual(folded.top);
    expect(intensityY(folded, 0, 0)).toBeLessThan(122);
  });
});

describe('DotGrid', () => {
  it('gives each cell once, and none outside', () => {
    const grid = new DotGrid(10, 4, 2);
    expect(grid.take(1, 1)).toBe(true);
    expect(grid.take(1, 1)).toBe(false);
    expect(grid.take(2, 1)).toBe(true);
    expect(grid.take(-1, 0)).toBe(false);
    expect(grid.take(0, 99)).toBe(false);
  });
});
