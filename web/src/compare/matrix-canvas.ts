/** The scene, its geometry and a picture in; cells, label ticks and numbers of clusters on a canvas out. */
import { labelStyle } from '../app/labels';
import { prepareCanvas } from '../timeline/canvas';
import { labelColour, type ComparePalette } from './compare-palette';
import { pixelOf, rgbOf } from './colour-scale';
import { positionsUnder } from './matrix-axis';
import { topPx, type MatrixGeometry } from './matrix-geometry';
import { paintMatrix, type PlacedPicture } from './matrix-pixels';
import type { Scene } from './scene';

export interface MatrixDrawing {
  readonly scene: Scene;
  readonly geometry: MatrixGeometry;
  readonly palette: ComparePalette;
  readonly font: string;
  /** null until the first one has arrived. */
  readonly placed: PlacedPicture | null;
  readonly colours: Uint32Array;
}

export const tickPx = { top: 9, height: 4 };
export const numberBaselinePx = 14;
/** Below this cell size the diagonal has no marks and ticks no gaps. */
const leastMarkedPx = 6;
/** Of the numbers of clusters. */
export const digitPx = 6.4;

/** Paints cells pixel by pixel of the device: no cell is blurred, however small. */
export class MatrixCanvas {
  readonly canvas = document.createElement('canvas');
  private image: ImageData | null = null;

  draw(drawing: MatrixDrawing): void {
    const { geometry } = drawing;
    const context = prepareCanvas(this.canvas, geometry.side, geometry.side + topPx);
    if (!context) return;
    this.canvas.style.width = `${geometry.side}px`;
    this.canvas.style.height = `${geometry.side + topPx}px`;
    this.canvas.style.left = `${geometry.left}px`;
    this.drawCells(context, drawing);
    drawDiagonal(context, drawing);
    drawTicks(context, drawing);
    drawNumbers(context, drawing);
  }

  private drawCells(context: CanvasRenderingContext2D, drawing: MatrixDrawing): void {
    const { geometry, placed, palette, colours } = drawing;
    const { axis, side, zoom } = geometry;
    const ratio = window.devicePixelRatio;
    const pixels = Math.round(side * ratio);
    if (!placed || pixels < 1) return;
    if (this.image?.width !== pixels) this.image = new ImageData(pixels, pixels);
    paintMatrix(new Uint32Array(this.image.data.buffer), {
      placed,
      colours,
      rows: positionsUnder(axis, zoom.y, pixels, ratio),
      columns: positionsUnder(axis, zoom.x, pixels, ratio),
      background: pixelOf(rgbOf(palette.panel)),
    });
    context.putImageData(this.image, 0, Math.round(topPx * ratio));
  }
}

/** The positions in sight along a scroll. */
export function positionsInSight(
  { axis, side }: MatrixGeometry,
  scroll: number,
): { first: number; end: number } {
  if (axis.count === 0) return { first: 0, end: 0 };
  return { first: axis.nearest(scroll), end: axis.nearest(scroll + side - 0.01) + 1 };
}

function drawDiagonal(context: CanvasRenderingContext2D, drawing: MatrixDrawing): void {
  const { geometry, palette } = drawing;
  const { axis, zoom, side } = geometry;
  if (axis.cell < leastMarkedPx) return;
  context.fillStyle = palette.line3;
  const { first, end } = positionsInSight(geometry, zoom.y);
  for (let position = first; position < end; position += 1) {
    const x = axis.middle(position) - zoom.x;
    if (x < 0 || x > side) continue;
    context.beginPath();
    context.arc(x, topPx + axis.middle(position) - zoom.y, 1.2, 0, 2 * Math.PI);
    context.fill();
  }
}

/** A line over the columns, in the colours of their labels; open where the label's shape is open. */
function drawTicks(context: CanvasRenderingContext2D, drawing: MatrixDrawing): void {
  const { geometry, palette, scene } = drawing;
  const { axis, zoom, side } = geometry;
  const space = axis.cell >= leastMarkedPx ? 1 : 0;
  const top = topPx - tickPx.top;
  const { first, end } = positionsInSight(geometry, zoom.x);
  context.save();
  context.beginPath();
  context.rect(0, 0, side, topPx);
  context.clip();
  for (let position = first; position < end; position += 1) {
    const label = scene.labelOfItem[scene.order[position]];
    if (label < 0) continue;
    context.fillStyle = labelColour(palette, label);
    const x = axis.start(position) - zoom.x;
    const width = Math.max(axis.cell - space, 0.5);
    context.fillRect(x, top, width, tickPx.height);
    if (labelStyle(label).open && space)
      context.clearRect(x + 1, top + 1, width - 2, tickPx.height - 2);
  }
  context.restore();
}

/** Runs of one group: their first position and one past their last. */
export function groupRuns(groups: Int32Array): { group: number; first: number; end: number }[] {
  const runs: { group: number; first: number; end: number }[] = [];
  groups.forEach((group, position) => {
    const run = runs.at(-1);
    if (run?.group === group) run.end = position + 1;
    else runs.push({ group, first: position, end: position + 1 });
  });
  return runs;
}

function drawNumbers(context: CanvasRenderingContext2D, drawing: MatrixDrawing): void {
  const { geometry, palette, scene, font } = drawing;
  const { axis, zoom, side } = geometry;
  if (scene.kind !== 'tree' || !scene.cut) return;
  context.fillStyle = palette.text3;
  context.font = `10.5px ${font}`;
  context.textAlign = 'center';
  let right = -Infinity;
  for (const { group, first, end } of groupRuns(scene.groups)) {
    const from = Math.max(0, axis.start(first) - zoom.x);
    const to = Math.min(side, axis.start(end - 1) + axis.cell - zoom.x);
    const half = (String(group + 1).length * digitPx) / 2;
    const middle = Math.max(half, Math.min(side - half, (from + to) / 2));
    // Of numbers that would touch each other the first stands.
    if (to <= from || middle - half < right + digitPx / 2) continue;
    context.fillText(String(group + 1), middle, numberBaselinePx);
    right = middle + half;
  }
}
