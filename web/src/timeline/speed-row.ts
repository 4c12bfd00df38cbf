/** Draws the row of motion speed: area, trend, curve and the keyposes upon it. */
import type { Row } from './rows';
import type { Scene } from './scene';
import { hasStems } from './scene';
import { type Columns, reduceToColumns } from './speed-columns';

const HEADROOM = 1.04;
const FOOT = 3;
const AIR = 9;

/** Height of a speed, in pixels from the timeline's upper edge. */
export function speedY(row: Row, speed: number, maximum: number): number {
  const base = row.top + row.height - FOOT;
  return base - (maximum > 0 ? speed / (maximum * HEADROOM) : 0) * (row.height - AIR);
}

export function drawSpeedRow(context: CanvasRenderingContext2D, scene: Scene): void {
  const { axis, data, palette, rows } = scene;
  const { firstFrame, maximumSpeed } = data.result;
  const columns = reduceToColumns(data.speed, firstFrame, axis);
  const trend = reduceToColumns(data.trend, firstFrame, axis);
  const y = (speed: number): number => speedY(rows.speed, speed, maximumSpeed);
  fillArea(context, columns, y, palette.ink);
  if (!rows.speed.folded) strokeTrend(context, trend, y, palette.text3);
  strokeCurve(context, columns, y, palette.ink);
  if (hasStems(scene) && !rows.speed.folded) drawDots(context, scene, y);
}

/** The keypose's disc on the curve, with a rim of the page. */
export function drawSpeedDot(
  context: CanvasRenderingContext2D,
  { axis, data, palette, rows }: Scene,
  keypose: number,
  radius: number,
): void {
  const frame = data.frames[keypose];
  const speed = data.speedAt(frame);
  if (speed === undefined) return;
  context.beginPath();
  context.arc(axis.x(frame), speedY(rows.speed, speed, data.result.maximumSpeed), radius, 0, 7);
  context.fillStyle = palette.kp;
  context.strokeStyle = palette.panel;
  context.lineWidth = 1.4;
  context.fill();
  context.stroke();
}

const DOT_RADIUS = 2.8;

function drawDots(
  context: CanvasRenderingContext2D,
  { axis, data, palette, keyposes }: Scene,
  y: (speed: number) => number,
): void {
  context.beginPath();
  for (let keypose = keyposes.from; keypose < keyposes.to; keypose++) {
    const frame = data.frames[keypose];
    const x = axis.x(frame);
    const at = y(data.speedAt(frame) ?? 0);
    context.moveTo(x + DOT_RADIUS, at);
    context.arc(x, at, DOT_RADIUS, 0, 2 * Math.PI);
  }
  context.fillStyle = palette.kp;
  context.strokeStyle = palette.panel;
  context.lineWidth = 1.4;
  context.fill();
  context.stroke();
}

type ToPixel = (speed: number) => number;

function fillArea(
  context: CanvasRenderingContext2D,
  { firstX, maximum }: Columns,
  y: ToPixel,
  ink: string,
): void {
  const base = y(0);
  context.beginPath();
  context.moveTo(firstX, base);
  for (let index = 0; index < maximum.length; index++)
    context.lineTo(firstX + index, y(maximum[index]));
  context.lineTo(firstX + maximum.length - 1, base);
  context.globalAlpha = 0.07;
  context.fillStyle = ink;
  context.fill();
  context.globalAlpha = 1;
}

function strokeTrend(
  context: CanvasRenderingContext2D,
  trend: Columns,
  y: ToPixel,
  colour: string,
): void {
  context.beginPath();
  for (let index = 0; index < trend.maximum.length; index++) {
    context.lineTo(trend.firstX + index, y((trend.maximum[index] + trend.minimum[index]) / 2));
  }
  context.setLineDash([3, 3]);
  context.lineWidth = 1;
  context.strokeStyle = colour;
  context.stroke();
  context.setLineDash([]);
}

/** A line through both ends of every column, the end nearer to the last point first. */
function strokeCurve(
  context: CanvasRenderingContext2D,
  { firstX, minimum, maximum }: Columns,
  y: ToPixel,
  ink: string,
): void {
  context.beginPath();
  let previous = minimum[0];
  for (let index = 0; index < minimum.length; index++) {
    const [low, high] = [minimum[index], maximum[index]];
    const rising = previous - low <= high - previous;
    context.lineTo(firstX + index, y(rising ? low : high));
    context.lineTo(firstX + index, y(rising ? high : low));
    previous = rising ? high : low;
  }
  context.lineWidth = 1.35;
  context.lineJoin = 'round';
  context.strokeStyle = ink;
  context.stroke();
}
