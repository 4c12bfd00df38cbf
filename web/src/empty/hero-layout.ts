/** In: a sample's speed and keyposes, the width there is. Out: where the curve, the pins and the figures of the hero stand. */
import { fitting, spread } from './spread';
import type { SamplePicture } from './sample-picture';

export const heroHeight = 300;
export const baseY = heroHeight - 26;
export const groundY = 176;
export const bodyPx = 108;
const curveHeight = 72;
/** Between the edge and the outermost figures; the curve goes on through it and fades. */
const sidePadding = 36;
const figureGap = 6;
/** Where the curve's name stands. */
export const speedX = 40;
const speedWidth = 40;

export interface HeroPlace {
  readonly index: number;
  /** The pin on the curve. */
  readonly x: number;
  readonly y: number;
  /** The middle of the figure above it. */
  readonly figureX: number;
}

export interface HeroLayout {
  readonly curve: string;
  readonly area: string;
  readonly places: readonly HeroPlace[];
  /** Just above the curve where its name stands. */
  readonly speedY: number;
}

/** Shows as many of the first keyposes as have room. */
export function heroLayout(
  { keyposes, frames, figures }: SamplePicture,
  width: number,
): HeroLayout {
  const widths = figures.map((figure) => bodyPx * (figure.maxX - figure.minX));
  const count = Math.max(1, fitting(widths, figureGap, width - 2 * sidePadding));
  const shown = Array.from(frames.subarray(0, count));
  const first = shown[0] ?? 0;
  const inner = sidePadding + bodyPx / 2;
  const scale = (width - 2 * inner) / Math.max(1, (shown.at(-1) ?? first) - first);
  const x = (frame: number): number => inner + (frame - first) * scale;
  const y = (frame: number): number =>
    baseY -
    ((keyposes.speed[frame - keyposes.firstFrame] ?? 0) / keyposes.maximumSpeed) * curveHeight;
  const points = Array.from(keyposes.speed.keys(), (index) => index + keyposes.firstFrame)
    .map((frame) => ({ x: x(frame), y: y(frame) }))
    .filter((point) => point.x > -4 && point.x < width + 4);
  const named = points.filter((point) => point.x > speedX && point.x < speedX + speedWidth);
  const curve = `M${points.map((point) => `${point.x.toFixed(1)} ${point.y.toFixed(1)}`).join('L')}`;
  const figureX = spread(
    shown.map(x),
    widths.slice(0, count),
    figureGap,
    sidePadding,
    width - sidePadding,
  );
  return {
    curve,
    area: `${curve}V${baseY}H${points[0]?.x ?? 0}Z`,
    speedY: Math.min(baseY, ...named.map((point) => point.y)) - 8,
    places: shown.map((frame, index) => ({
      index,
      x: x(frame),
      y: y(frame),
      figureX: figureX[index] ?? 0,
    })),
  };
}
