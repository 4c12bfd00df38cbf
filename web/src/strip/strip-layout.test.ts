import { describe, expect, it } from 'vitest';
import { layoutStrip, spread } from './strip-layout';

describe('spread', () => {
  it('leaves places alone that are far enough apart', () => {
    expect(spread([100, 200, 300], 50, 0, 400)).toEqual([100, 200, 300]);
  });

  it('moves neighbours that overlap by equal amounts', () => {
    expect(spread([100, 110], 50, 0, 400)).toEqual([80, 130]);
  });

  it('stays inside the strip', () => {
    expect(spread([0, 5, 395], 60, 30, 370)).toEqual([30, 90, 370]);
    expect(spread([390, 395], 60, 30, 370)).toEqual([310, 370]);
  });
});

describe('layoutStrip', () => {
  it('shows all keyposes that fit', () => {
    const layout = layoutStrip([50, 150, 250], [1, 2, 3], 300);
    expect(layout.cards.map((card) => card.keypose)).toEqual([0, 1, 2]);
    expect(layout.cardWidth).toBe(63);
  });

  it('shows the most intense where not all fit, in time order', () => {
    const layout = layoutStrip([10, 60, 110, 160, 210], [5, 1, 4, 1, 3], 150);
    expect(layout.cards.map((card) => card.keypose)).toEqual([0, 2, 4]);
    expect(layout.cardWidth).toBeGreaterThanOrEqual(48);
  });

  it('has no cards without room', () => {
    expect(layoutStrip([10], [1], 20).cards).toEqual([]);
  });
});
