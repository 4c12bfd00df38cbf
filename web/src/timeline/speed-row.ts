/** Draws the row of motion speed: area, trend, curve and the keyposes upon it. */
import { paintDots } from './dots';
import type { Row } from './rows';
import type { Scene } from './scene';
import { standingApart } from './scene';
import { type Curve, curveOf } from './speed-curve';

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
  const curve = curveOf(data.speed, firstFrame, axis);
  const trend = curveOf(data.trend, firstFrame, axis);
  const y = (speed: number): number => speedY(rows.speed, speed, maximumSpeed);
  fillArea(context, curve, y, palette.ink);
  if (!rows.speed.folded) strokeTrend(context, trend, y, palette.text3);
  drawCurve(context, curve, y, palette.ink);
  if (!rows.speed.folded) drawDots(context, scene, y);
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
  paintDots(context, palette.kp, palette.panel, 1.4);
}

const DOT_RADIUS = 2.8;

function drawDots(
  context: CanvasRenderingContext2D,
  scene: Scene,
  y: (speed: number) => number,
): void {
  const { axis, data, palette } = scene;
  context.beginPath();
  for (const keypose of standingApart(scene)) {
    const frame = data.frames[keypose];
    const x = axis.x(frame);
    const at = y(data.speedAt(frame) ?? 0);
    context.moveTo(x + DOT_RADIUS, at);
    context.arc(x, at, DOT_RADIUS, 0, 2 * Math.PI);
  }
  paintDots(context, palette.kp, palette.panel, 1.4);
}

type ToPixel = (speed: number) => number;

function fillArea(
  context: CanvasRenderingContext2D,
  { x, maximum }: Curve,
  y: ToPixel,
  ink: string,
): void {
  if (x.length === 0) return;
  const base = y(0);
  context.beginPath();
  context.moveTo(x[0], base);
  for (let index = 0; index < x.length; index++) context.lineTo(x[index], y(maximum[index]));
  context.lineTo(x[x.length - 1], base);
  context.globalAlpha = 0.07;
  context.fillStyle = ink;
  context.fill();
  context.globalAlpha = 1;
}

function strokeTrend(
  context: CanvasRenderingContext2D,
  { x, minimum, maximum }: Curve,
  y: ToPixel,
  colour: string,
): void {
  context.beginPath();
  for (let index = 0; index < x.length; index++)
    context.lineTo(x[index], y((minimum[index] + maximum[index]) / 2));
  context.setLineDash([3, 3]);
  context.lineWidth = 1;
  context.strokeStyle = colour;
  context.stroke();
  context.setLineDash([]);
}

const LINE_WIDTH = 1.35;

/** A line from frame to frame, or the band between the extremes of each pixel, as thick as a line at least. */
function drawCurve(
  context: CanvasRenderingContext2D,
  { x, minimum, maximum }: Curve,
  y: ToPixel,
  ink: string,
): void {
  context.beginPath();
  const isLine = minimum === maximum;
  const rim = isLine ? 0 : LINE_WIDTH / 2;
  for (let index = 0; index < x.length; index++) context.lineTo(x[index], y(maximum[index]) - rim);
  if (isLine) {
    context.lineWidth = LINE_WIDTH;
    context.lineJoin = 'round';
    context.strokeStyle = ink;
    context.stroke();
    return;
  }
  for (let index = x.length - 1; index >= 0; index--)
    context.lineTo(x[index], y(minimum[index]) + rim);
  context.fillStyle = ink;
  context.fill();
}
