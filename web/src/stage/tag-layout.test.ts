import { describe, expect, it } from 'vitest';
import { layTags, TAG_HEIGHT, type TagArea, type TagPlace } from './tag-layout';

const area: TagArea = { width: 800, height: 340, left: 120, right: 60 };
const tag = (x: number, y = 200, width = 16): TagPlace => ({ x, y, width });

function expectApart(tags: readonly TagPlace[]): void {
  tags.forEach((a, i) => {
    for (const b of tags.slice(i + 1)) {
      const aside = Math.abs(a.x - b.x) >= (a.width + b.width) / 2;
      expect(aside || Math.abs(a.y - b.y) >= TAG_HEIGHT, JSON.stringify([a, b])).toBe(true);
    }
  });
}

function expectInside(tags: readonly TagPlace[], { width, height }: TagArea): void {
  for (const { x, y, width: w } of tags) {
    expect(x - w / 2).toBeGreaterThanOrEqual(0);
    expect(x + w / 2).toBeLessThanOrEqual(width);
    expect(y - TAG_HEIGHT / 2).toBeGreaterThanOrEqual(0);
    expect(y + TAG_HEIGHT / 2).toBeLessThanOrEqual(height);
  }
}

describe('layTags', () => {
  it('leaves tags that do not touch where they are', () => {
    const tags = [tag(300), tag(400), tag(350, 230)];
    layTags(tags, area);
    expect(tags.map(({ x, y }) => [x, y])).toEqual([
      [300, 200],
      [350, 230],
      [400, 200],
    ]);
  });

  it('moves tags apart, each by as much', () => {
    const tags = [tag(404), tag(400)];
    layTags(tags, area);
    expectApart(tags);
    expect(tags[0].x).toBeLessThan(tags[1].x);
    expect((tags[0].x + tags[1].x) / 2).toBeCloseTo(402, 6);
  });

  it('on one spot, at an edge and in a corner they are still apart and inside', () => {
    for (const [x, y] of [
      [400, 200],
      [-50, 200],
      [900, 200],
      [900, 900],
      [0, 900],
      [400, -20],
    ]) {
      const tags = [tag(x, y), tag(x, y, 30), tag(x, y + 4), tag(x + 1, y, 23)];
      layTags(tags, area);
      expectApart(tags);
      expectInside(tags, area);
    }
  });

  it('keeps them off the words in the lower corners', () => {
    const tags = [tag(60, 335), tag(400, 335), tag(770, 335)];
    layTags(tags, area);
    expect(tags[0].y).toBeLessThan(area.height - 30);
    expect(tags[1].y).toBeGreaterThan(area.height - 20);
    expect(tags[2].y).toBeLessThan(area.height - 30);
  });
});
