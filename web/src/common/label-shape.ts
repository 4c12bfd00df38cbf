/** A shape, its middle and its radius in; SVG path data out, for canvas, SVG and pictures alike. */
export const labelShapes = ['circle', 'square', 'triangle', 'diamond', 'inverted', 'plus'] as const;
export type LabelShape = (typeof labelShapes)[number];

type Corner = readonly [x: number, y: number];

/** Corners for radius 1; the areas are about equal, so that no shape weighs more. */
const corners: Readonly<Record<Exclude<LabelShape, 'circle'>, readonly Corner[]>> = {
  square: [
    [-0.88, -0.88],
    [0.88, -0.88],
    [0.88, 0.88],
    [-0.88, 0.88],
  ],
  triangle: [
    [0, -1.1],
    [1.15, 0.9],
    [-1.15, 0.9],
  ],
  inverted: [
    [0, 1.1],
    [1.15, -0.9],
    [-1.15, -0.9],
  ],
  diamond: [
    [0, -1.25],
    [1.25, 0],
    [0, 1.25],
    [-1.25, 0],
  ],
  plus: [
    [-0.4, -1.15],
    [0.4, -1.15],
    [0.4, -0.4],
    [1.15, -0.4],
    [1.15, 0.4],
    [0.4, 0.4],
    [0.4, 1.15],
    [-0.4, 1.15],
    [-0.4, 0.4],
    [-1.15, 0.4],
    [-1.15, -0.4],
    [-0.4, -0.4],
  ],
};

const rounded = (value: number): number => Math.round(value * 100) / 100;

export function shapePath(shape: LabelShape, x: number, y: number, radius: number): string {
  if (shape === 'circle') {
    const [left, r, d] = [rounded(x - radius), rounded(radius), rounded(2 * radius)];
    return `M${left} ${rounded(y)}a${r} ${r} 0 1 0 ${d} 0a${r} ${r} 0 1 0 ${-d} 0z`;
  }
  const points = corners[shape].map(
    ([dx, dy]) => `${rounded(x + dx * radius)} ${rounded(y + dy * radius)}`,
  );
  return `M${points.join('L')}z`;
}
