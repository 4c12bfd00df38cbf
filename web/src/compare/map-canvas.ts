/** Places on the screen and their labels in; hulls, the pair's line and the discs on a canvas out. */
import { prepareCanvas } from '../timeline/canvas';
import type { ComparePalette } from './compare-palette';
import { convexHull, type Point } from './hull';
import { shapePath } from './label-shape';
import { markLook } from './mark-tag';
import type { Scene } from './scene';
import type { ItemPair } from './shared';

export interface MapDrawing {
  readonly scene: Scene;
  readonly palette: ComparePalette;
  readonly points: readonly Point[];
  readonly width: number;
  readonly height: number;
  readonly selected: ItemPair;
  readonly hovered: ItemPair | null;
}

const hullWidthPx = 24;
const ringPx = 9;

/** Half a disc; thousands are drawn smaller. */
export const discRadius = (count: number): number => (count > 2000 ? 2.5 : count > 400 ? 3.5 : 4.5);

/** Items of each cluster, in the order of the tree. */
export function membersOf({ cut, count }: Scene): readonly (readonly number[])[] {
  if (!cut) return [];
  const members: number[][] = Array.from({ length: cut.clusters }, () => []);
  for (let item = 0; item < count; item += 1) members[cut.clusterOfItem[item]]?.push(item);
  return members;
}

export function hullPathOf(corners: readonly Point[]): string {
  const [first, ...others] = corners.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`);
  return others.length > 0 ? `M${first}L${others.join('L')}z` : `M${first}h.01`;
}

/** Discs drawn once by label: thousands are then copied. */
class Sprites {
  private readonly made = new Map<number, HTMLCanvasElement>();
  readonly size: number;

  constructor(
    private readonly palette: ComparePalette,
    private readonly radius: number,
    private readonly ratio: number,
  ) {
    this.size = 2 * (radius * 1.3 + 2);
  }

  of(label: number): HTMLCanvasElement {
    const known = this.made.get(label);
    if (known) return known;
    const sprite = document.createElement('canvas');
    sprite.width = sprite.height = Math.ceil(this.size * this.ratio);
    const context = sprite.getContext('2d');
    if (context) {
      context.scale(this.ratio, this.ratio);
      drawMark(context, this.palette, label, this.size / 2, this.radius);
    }
    this.made.set(label, sprite);
    return sprite;
  }
}

function drawMark(
  context: CanvasRenderingContext2D,
  palette: ComparePalette,
  label: number,
  middle: number,
  radius: number,
): void {
  const { shape, colour, open } = markLook(palette, label);
  const path = new Path2D(shapePath(shape, middle, middle, radius));
  context.strokeStyle = palette.panel;
  context.lineWidth = 2.4;
  context.stroke(path);
  context.fillStyle = open ? palette.panel : colour;
  context.fill(path);
  if (!open) return;
  context.strokeStyle = colour;
  context.lineWidth = 1.5;
  context.stroke(path);
}

export class MapCanvas {
  readonly canvas = document.createElement('canvas');
  private sprites: { key: string; sprites: Sprites } | null = null;

  draw(drawing: MapDrawing): void {
    const context = prepareCanvas(this.canvas, drawing.width, drawing.height);
    if (!context) return;
    this.canvas.style.width = `${drawing.width}px`;
    this.canvas.style.height = `${drawing.height}px`;
    drawHulls(context, drawing);
    drawLine(context, drawing);
    this.drawDiscs(context, drawing);
    drawRings(context, drawing);
  }

  private drawDiscs(context: CanvasRenderingContext2D, drawing: MapDrawing): void {
    const { scene, palette, points, width, height } = drawing;
    const sprites = this.spritesFor(palette, discRadius(scene.count));
    const half = sprites.size / 2;
    points.forEach(([x, y], item) => {
      if (x < -half || y < -half || x > width + half || y > height + half) return;
      const sprite = sprites.of(scene.labelOfItem[item]);
      context.drawImage(sprite, x - half, y - half, sprites.size, sprites.size);
    });
  }

  private spritesFor(palette: ComparePalette, radius: number): Sprites {
    const ratio = window.devicePixelRatio;
    const key = [radius, ratio, palette.panel, ...palette.labels].join();
    if (this.sprites?.key !== key)
      this.sprites = { key, sprites: new Sprites(palette, radius, ratio) };
    return this.sprites.sprites;
  }
}

function drawHulls(
  context: CanvasRenderingContext2D,
  { scene, palette, points }: MapDrawing,
): void {
  context.lineJoin = context.lineCap = 'round';
  // Fill and outline together, so that they do not add up where they overlap.
  context.fillStyle = context.strokeStyle = hullColour(palette);
  context.lineWidth = hullWidthPx;
  for (const members of membersOf(scene)) {
    if (members.length === 0) continue;
    const path = new Path2D(hullPathOf(convexHull(members.map((item) => points[item]))));
    context.fill(path);
    context.stroke(path);
  }
}

/** Ink at 4 % on the panel, opaque. */
export function hullColour({ panel, inkParts }: ComparePalette): string {
  const ink = inkParts.split(' ').map(Number);
  const ground = [1, 3, 5].map((at) => Number.parseInt(panel.slice(at, at + 2), 16));
  return `rgb(${ground.map((byte, k) => Math.round(byte * 0.96 + ink[k] * 0.04)).join(' ')})`;
}

function drawLine(context: CanvasRenderingContext2D, drawing: MapDrawing): void {
  const { a, b } = drawing.selected;
  if (a === null || b === null) return;
  context.strokeStyle = drawing.palette.kp;
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(...drawing.points[a]);
  context.lineTo(...drawing.points[b]);
  context.stroke();
}

function drawRings(context: CanvasRenderingContext2D, drawing: MapDrawing): void {
  const { selected, hovered, points, palette } = drawing;
  const ring = (item: number | null, colour: string, width: number): void => {
    if (item === null) return;
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    context.arc(...points[item], ringPx, 0, 2 * Math.PI);
    context.stroke();
  };
  if (hovered) for (const item of [hovered.a, hovered.b]) ring(item, palette.ink, 1);
  for (const item of [selected.a, selected.b]) ring(item, palette.kp, 2);
}
