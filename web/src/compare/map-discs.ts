/**
 * Places on the screen and their labels in; the discs out. Each look is drawn once and stamped pixel by
 * pixel: ten thousand take a few milliseconds.
 */
import { labelLook } from '../app/labels';
import type { ComparePalette } from './compare-palette';
import { contextOf, discRadius, drawMark, type SpotDrawing } from './map-canvas';
import { labelAt } from './map-spots';

export interface Stamp {
  readonly width: number;
  /** One pixel a number: alpha in the highest byte. */
  readonly pixels: Uint32Array;
}

/** One pixel over another, both opaque enough to be mixed byte by byte. */
function over(top: number, bottom: number): number {
  const alpha = top >>> 24;
  if (alpha === 255 || bottom === 0) return top;
  if (alpha === 0) return bottom;
  let mixed = Math.max(alpha, bottom >>> 24) << 24;
  for (let shift = 0; shift < 24; shift += 8) {
    const [a, b] = [(top >>> shift) & 255, (bottom >>> shift) & 255];
    mixed |= Math.round((a * alpha + b * (255 - alpha)) / 255) << shift;
  }
  return mixed >>> 0;
}

/** Puts a stamp with its middle at (x, y) of an image; what lies outside is cut off. */
export function stamp(
  image: Uint32Array,
  width: number,
  { width: size, pixels }: Stamp,
  x: number,
  y: number,
): void {
  const height = image.length / width;
  const [left, top] = [Math.round(x - size / 2), Math.round(y - size / 2)];
  const [firstX, endX] = [Math.max(0, -left), Math.min(size, width - left)];
  const [firstY, endY] = [Math.max(0, -top), Math.min(size, height - top)];
  for (let row = firstY; row < endY; row += 1)
    for (let column = firstX; column < endX; column += 1) {
      const pixel = pixels[row * size + column];
      if (pixel >>> 24 === 0) continue;
      const at = (top + row) * width + left + column;
      image[at] = over(pixel, image[at]);
    }
}

function stampOf(palette: ComparePalette, label: number, radius: number, ratio: number): Stamp {
  const canvas = document.createElement('canvas');
  const width = Math.ceil(2 * (radius * 1.3 + 2) * ratio);
  canvas.width = canvas.height = width;
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) return { width: 0, pixels: new Uint32Array() };
  context.scale(ratio, ratio);
  context.translate(width / ratio / 2, width / ratio / 2);
  drawMark(context, palette, label, radius);
  const { data } = context.getImageData(0, 0, width, width);
  return { width, pixels: new Uint32Array(data.buffer) };
}

export class MapDiscs {
  private stamps = new Map<number, Stamp>();
  private key = '';

  draw(canvas: HTMLCanvasElement, drawing: SpotDrawing): void {
    const { spots, palette } = drawing;
    const { points } = spots;
    const context = contextOf(canvas, drawing);
    if (!context || canvas.width === 0 || canvas.height === 0) return;
    const ratio = window.devicePixelRatio;
    const radius = discRadius(points.length);
    this.forgetOld([radius, ratio, palette.panel, ...palette.labels].join());
    const image = new ImageData(canvas.width, canvas.height);
    const pixels = new Uint32Array(image.data.buffer);
    points.forEach(([x, y], spot) => {
      const label = labelLook(labelAt(spots, spot));
      const mark = this.stamps.get(label) ?? stampOf(palette, label, radius, ratio);
      this.stamps.set(label, mark);
      stamp(pixels, image.width, mark, x * ratio, y * ratio);
    });
    context.putImageData(image, 0, 0);
  }

  private forgetOld(key: string): void {
    if (key !== this.key) this.stamps = new Map();
    this.key = key;
  }
}
