import { describe, expect, it } from 'vitest';
import { labelDigits, layoutStrip, leastLabelWidth, spread, stripScale } from './strip-layout';

const room = { first: 0, end: 3, kept: null, width: 300, leastCard: 48 };

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
    const layout = layoutStrip([50, 150, 250], [1, 2, 3], room);
    expect(layout.cards.map((card) => card.keypose)).toEqual([0, 1, 2]);
    expect(layout.cardWidth).toBe(63);
  });

  it('shows the most intense where not all fit, in time order', () => {
    const layout = layoutStrip([10, 60, 110, 160, 210], [5, 1, 4, 1, 3], {
      ...room,
      end: 5,
      width: 150,
    });
    expect(layout.cards.map((card) => card.keypose)).toEqual([0, 2, 4]);
    expect(layout.cardWidth).toBeGreaterThanOrEqual(48);
  });

  it('has no cards without room', () => {
    expect(layoutStrip([10], [1], { ...room, end: 1, width: 20 }).cards).toEqual([]);
  });
});

describe('layoutStrip of a part', () => {
  const pins = [10, 60, 110, 160, 210];

  it('shows those of the span alone', () => {
    const { cards } = layoutStrip(pins, [5, 1, 4, 1, 3], { ...room, first: 1, end: 4 });
    expect(cards.map((card) => card.keypose)).toEqual([1, 2, 3]);
    expect(layoutStrip(pins, [], { ...room, first: 2, end: 2 }).cards).toEqual([]);
  });

  it('keeps one that would not fit for its intensity', () => {
    const narrow = { ...room, end: 5, width: 150, kept: 3 };
    const { cards } = layoutStrip(pins, [5, 1, 4, 1, 3], narrow);
    expect(cards.map((card) => card.keypose)).toEqual([0, 2, 3]);
  });

  it('makes cards as wide as their text, so that fewer fit', () => {
    const wide = { ...room, end: 5, width: 300, leastCard: leastLabelWidth(18_920, 36_000) };
    const { cards, cardWidth } = layoutStrip(pins, [5, 1, 4, 1, 3], wide);
    expect(cardWidth).toBeGreaterThanOrEqual(10 * 6.8 + 5);
    expect(cards.length * cardWidth).toBeLessThanOrEqual(300);
    expect(cards.at(-1)!.x + cardWidth / 2).toBeLessThanOrEqual(300);
  });
});

describe('labelDigits', () => {
  it('shortens the seconds until the line fits into its card', () => {
    expect(labelDigits(8, 17.9, 63)).toBe(2);
    expect(labelDigits(9, 7.45, 48)).toBe(2);
    expect(labelDigits(58, 35.83, 48)).toBe(1);
    expect(labelDigits(104, 512.25, 48)).toBe(0);
    expect(labelDigits(1000, 3599, 48)).toBe(0);
  });
});

describe('stripScale', () => {
  const figure = { minX: -0.2, maxX: 0.2, maxY: 1 };

  it('is that of a standing human, less where one leaps or is long', () => {
    expect(stripScale([figure], 48)).toBe(55);
    expect(stripScale([], 48)).toBe(55);
    expect(stripScale([figure, { ...figure, maxY: 1.55 }], 48)).toBeCloseTo(40, 9);
    const dog = { minX: -0.9, maxX: 0.6, maxY: 0.7 };
    expect(stripScale([dog], 48) * 1.5).toBeLessThan(1.2 * 48);
  });
});
