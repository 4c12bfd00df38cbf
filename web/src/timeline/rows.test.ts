import { describe, expect, it } from 'vitest';
import { FOLDED_HEIGHT, layoutRows, rowAt } from './rows';

describe('layoutRows', () => {
  it('stacks the rows without gaps, in their order', () => {
    const rows = layoutRows(new Set(), true);
    expect([rows.pins.top, rows.ruler.top, rows.speed.top, rows.scales.top]).toEqual([
      0, 24, 46, 104,
    ]);
    expect(rows.spanHeight).toBe(224);
    expect(rows.height).toBe(246);
  });

  it('closes up where a row is folded', () => {
    const rows = layoutRows(new Set(['scales']), true);
    expect(rows.scales).toEqual({ top: 104, height: FOLDED_HEIGHT, folded: true });
    expect(rows.height).toBe(246 - 72 + FOLDED_HEIGHT);
  });

  it('leaves one row for the reason where a clip has no keyposes, folded or not', () => {
    const rows = layoutRows(new Set(['speed']), false);
    expect([rows.speed.height, rows.scales.height, rows.intensity.height]).toEqual([58, 0, 0]);
    expect(rows.overview.top).toBe(104);
  });
});

describe('rowAt', () => {
  it('finds the row of each height', () => {
    const rows = layoutRows(new Set(['speed']), true);
    expect([0, 24, 46, 67, 68, 300].map((y) => rowAt(rows, y))).toEqual([
      'pins',
      'ruler',
      'speed',
      'speed',
      'scales',
      null,
    ]);
  });
});
