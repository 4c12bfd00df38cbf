/** Places on the screen and their labels in; hulls, the pair's line and the discs on a canvas out. */
import { prepareCanvas } from '../timeline/canvas';
import type { ComparePalette } from './compare-palette';
import { convexHull, type Point } from './hull';
import { middleMember, type Anchor } from './map-layout';
import { labelAt, type Spots } from './map-spots';
import { shapePath } from '../common/label-shape';
import { markLook } from './mark-tag';
import type { Scene } from './scene';
import type { ItemPair } from './shared';

export interface MapDrawing {
  readonly scene: Scene;
  readonly palette: ComparePalette;
  readonly points: readonly Point[];
  readonly width: number;
  readonly height: number;
}

export interface SpotDrawing {
  readonly spots: Spots;
  readonly palette: ComparePalette;
  readonly width: number;
  readonly height: number;
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

export interface ClusterAnchor extends Anchor {
  readonly item: number;
}

/** Of the largest clusters the member in the middle, and the corners around all of them. */
export function clusterAnchors(
  scene: Scene,
  points: readonly Point[],
  most: number,
): readonly ClusterAnchor[] {
  return membersOf(scene)
    .filter((members) => members.length > 0)
    .sort((a, b) => b.length - a.length)
    .slice(0, most)
    .map((members) => {
      const item = middleMember(members, scene.comparison.map);
      return { item, at: points[item], hull: convexHull(members.map((other) => points[other])) };
    });
}

export function hullPathOf(corners: readonly Point[]): string {
  // Clips that are alike lie on each other: a line to the same place would not be drawn.
  const places = new Set(corners.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`));
  const [first, ...others] = places;
  return others.length > 0 ? `M${first}L${others.join('L')}z` : `M${first}h.01`;
}

/** In its size on the page, cleared. */
export function contextOf(
  canvas: HTMLCanvasElement,
  { width, height }: { readonly width: number; readonly height: number },
): CanvasRenderingContext2D | null {
  canvas.style.width = `${width}px`;
  canvas.style.height = `${height}px`;
  return prepareCanvas(canvas, width, height);
}

export function drawHulls(canvas: HTMLCanvasElement, drawing: MapDrawing): void {
  const { scene, palette, points } = drawing;
  const context = contextOf(canvas, drawing);
  if (!context) return;
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

/** Over the discs: the pair's line, and rings around what is selected and hovered. */
export function drawMarks(
  canvas: HTMLCanvasElement,
  drawing: SpotDrawing & { readonly selected: ItemPair; readonly hovered: ItemPair | null },
): void {
  const context = contextOf(canvas, drawing);
  if (!context) return;
  const { selected, hovered, spots, palette } = drawing;
  const { points } = spots;
  drawLine(context, drawing, selected);
  for (const spot of [selected.a, selected.b])
    if (spot !== null) {
      context.save();
      context.translate(...points[spot]);
      drawMark(context, palette, labelAt(spots, spot), discRadius(points.length));
      context.restore();
    }
  const ring = (spot: number | null, colour: string, width: number): void => {
    if (spot === null) return;
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    context.arc(...points[spot], ringPx, 0, 2 * Math.PI);
    context.stroke();
  };
  if (hovered) for (const spot of [hovered.a, hovered.b]) ring(spot, palette.ink, 1);
  for (const spot of [selected.a, selected.b]) ring(spot, palette.kp, 2);
}

function drawLine(
  context: CanvasRenderingContext2D,
  { spots: { points }, palette }: SpotDrawing,
  { a, b }: ItemPair,
): void {
  if (a === null || b === null) return;
  context.strokeStyle = palette.kp;
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(...points[a]);
  context.lineTo(...points[b]);
  context.stroke();
}

/** A disc at the origin. */
export function drawMark(
  context: CanvasRenderingContext2D,
  palette: ComparePalette,
  label: number,
  radius: number,
): void {
  const { shape, colour, open } = markLook(palette, label);
  const path = new Path2D(shapePath(shape, 0, 0, radius));
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
