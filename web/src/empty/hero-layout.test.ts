import { expect, test } from 'vitest';
import type { FlatFigure } from '../figure/flat-figure';
import { baseY, bodyPx, heroLayout } from './hero-layout';
import type { SamplePicture } from './sample-picture';

function figure(minX: number, maxX: number): FlatFigure {
  return { limbs: [], minX, maxX, minY: 0, maxY: 1 };
}

const frames = Int32Array.of(12, 40, 45, 90);
const picture = {
  motion: 'slow-dance',
  frames,
  figures: [figure(-0.5, 0.5), figure(-0.2, 0.6), figure(-0.3, 0.3), figure(-0.5, 0.1)],
  keyposes: {
    firstFrame: 2,
    maximumSpeed: 4,
    speed: Float64Array.from({ length: 100 }, (_, n) => (frames.includes(n + 2) ? 0 : 4)),
  },
} as unknown as SamplePicture;

function gaps(width: number): number[] {
  const { places } = heroLayout(picture, width);
  const half = (index: number): number => {
    const { minX, maxX } = picture.figures[index];
    return ((maxX - minX) * bodyPx) / 2;
  };
  return places
    .slice(1)
    .map(({ figureX }, i) => figureX - half(i + 1) - (places[i].figureX + half(i)));
}

test('no figure stands in another, and as many are shown as have room', () => {
  for (const width of [358, 480, 768, 1080]) {
    expect(Math.min(...gaps(width))).toBeGreaterThanOrEqual(5.99);
    expect(heroLayout(picture, width).places.length).toBe(width < 400 ? 3 : 4);
  }
});

test('a pin lies on the curve at its keypose', () => {
  const { places, curve } = heroLayout(picture, 1080);
  for (const { x, y } of places) {
    expect(y).toBe(baseY);
    expect(curve).toContain(`${x.toFixed(1)} ${y.toFixed(1)}`);
  }
});
