/** Draws the speed row on a canvas: area, trend and curve, once for each size, theme or result. */
import type { KeyposeResult } from '../engine/types';
import type { Axis } from './axis';
import { type Columns, reduceToColumns } from './speed-columns';

export const SPEED_ROW_HEIGHT = 58;
const BASE = SPEED_ROW_HEIGHT - 3;
const HEADROOM = 1.04;

/** Height of a speed above the row's lower edge, as a pixel of the row. */
export function speedY(speed: number, maximum: number): number {
  return BASE - (maximum > 0 ? speed / (maximum * HEADROOM) : 0) * (SPEED_ROW_HEIGHT - 9);
}

/** Draws the whole row; the canvas gets the device's pixels. */
export function drawSpeedRow(canvas: HTMLCanvasElement, axis: Axis, keyposes: KeyposeResult): void {
  const context = prepare(canvas, axis.width);
  if (context === null || keyposes.speed.length === 0) return;
  const style = getComputedStyle(canvas);
  const ink = style.getPropertyValue('--t-1').trim();
  const columns = reduceToColumns(keyposes.speed, keyposes.firstFrame, axis);
  const trend = reduceToColumns(keyposes.trend, keyposes.firstFrame, axis);
  const maximum = keyposes.maximumSpeed;
  fillArea(context, columns, maximum, ink);
  strokeTrend(context, trend, maximum, style.getPropertyValue('--t-3').trim());
  strokeCurve(context, columns, maximum, ink);
}

function prepare(canvas: HTMLCanvasElement, width: number): CanvasRenderingContext2D | null {
  const ratio = window.devicePixelRatio;
  canvas.width = Math.max(1, Math.round(width * ratio));
  canvas.height = Math.round(SPEED_ROW_HEIGHT * ratio);
  const context = canvas.getContext('2d');
  context?.scale(ratio, ratio);
  return context;
}

function fillArea(
  context: CanvasRenderingContext2D,
  columns: Columns,
  maximum: number,
  ink: string,
): void {
  context.beginPath();
  context.moveTo(columns.firstX, BASE);
  columns.maximum.forEach((speed, index) =>
    context.lineTo(columns.firstX + index, speedY(speed, maximum)),
  );
  context.lineTo(columns.firstX + columns.maximum.length - 1, BASE);
  context.globalAlpha = 0.07;
  context.fillStyle = ink;
  context.fill();
  context.globalAlpha = 1;
}

function strokeTrend(
  context: CanvasRenderingContext2D,
  trend: Columns,
  maximum: number,
  colour: string,
): void {
  context.beginPath();
  trend.maximum.forEach((speed, index) => {
    const middle = (speed + trend.minimum[index]) / 2;
    context.lineTo(trend.firstX + index, speedY(middle, maximum));
  });
  context.setLineDash([3, 3]);
  context.lineWidth = 1;
  context.strokeStyle = colour;
  context.stroke();
  context.setLineDash([]);
}

/** A line through both ends of every column, the end nearer to the last point first. */
function strokeCurve(
  context: CanvasRenderingContext2D,
  columns: Columns,
  maximum: number,
  ink: string,
): void {
  context.beginPath();
  let previous = columns.minimum[0];
  columns.minimum.forEach((low, index) => {
    const high = columns.maximum[index];
    const rising = previous - low <= high - previous;
    const ends = rising ? [low, high] : [high, low];
    for (const speed of ends) context.lineTo(columns.firstX + index, speedY(speed, maximum));
    previous = ends[1]!;
  });
  context.lineWidth = 1.35;
  context.lineJoin = 'round';
  context.strokeStyle = ink;
  context.stroke();
}
