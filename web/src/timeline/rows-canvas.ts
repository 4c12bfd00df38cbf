/**
 * The drawn rows: one canvas for all that stays while the motion plays, one above it for the current
 * keypose, so that a step from keypose to keypose draws one of each thing and no more.
 */
import { prepareCanvas } from './canvas';
import { drawCurrentDot, drawIntensityRow } from './intensity-row';
import { drawRulerTicks } from './ruler';
import type { Tick } from './ruler-layout';
import { drawCurrentTrace, drawScaleRow } from './scale-row';
import { standingApart, type Scene } from './scene';
import { drawSpeedDot, drawSpeedRow } from './speed-row';
import type { Axis } from './axis';
import type { Palette } from './palette';
import type { RowLayout } from './rows';

/** Middle of the pins, where the stems begin. */
const PIN_MIDDLE = 12;
const CURRENT_DOT = 4;

export class RowsCanvas {
  readonly still = document.createElement('canvas');
  readonly current = document.createElement('canvas');

  constructor() {
    for (const canvas of [this.still, this.current]) {
      canvas.className = 'timeline-canvas';
      canvas.setAttribute('aria-hidden', 'true');
    }
  }

  /** Draws all rows; without a scene the ruler alone. */
  draw(
    axis: Axis,
    rows: RowLayout,
    palette: Palette,
    ticks: readonly Tick[],
    scene: Scene | null,
  ): void {
    const context = this.prepare(this.still, axis, rows);
    if (context === null) return;
    drawRulerTicks(context, ticks, rows.ruler, palette);
    if (scene === null) return;
    drawStems(context, scene);
    drawScaleRow(context, scene);
    drawSpeedRow(context, scene);
    drawIntensityRow(context, scene);
  }

  drawCurrent(axis: Axis, rows: RowLayout, scene: Scene | null, keypose: number | null): void {
    const context = this.prepare(this.current, axis, rows);
    if (context === null || scene === null || keypose === null) return;
    if (keypose < scene.keyposes.from || keypose >= scene.keyposes.to) return;
    const x = axis.x(scene.data.frames[keypose]);
    strokeStems(context, scene, [x], scene.palette.kp, 1.25);
    drawCurrentTrace(context, scene, keypose);
    drawSpeedDot(context, scene, keypose, CURRENT_DOT);
    drawCurrentDot(context, scene, keypose);
  }

  private prepare(
    canvas: HTMLCanvasElement,
    axis: Axis,
    rows: RowLayout,
  ): CanvasRenderingContext2D | null {
    canvas.style.height = `${rows.spanHeight}px`;
    return prepareCanvas(canvas, axis.width, rows.spanHeight);
  }
}

function drawStems(context: CanvasRenderingContext2D, scene: Scene): void {
  const { axis, data, palette } = scene;
  const places = standingApart(scene).map((keypose) => axis.x(data.frames[keypose]));
  strokeStems(context, scene, places, palette.kpLine, 1);
}

function strokeStems(
  context: CanvasRenderingContext2D,
  { rows }: Scene,
  places: readonly number[],
  colour: string,
  width: number,
): void {
  context.beginPath();
  for (const x of places) {
    context.moveTo(x, PIN_MIDDLE);
    context.lineTo(x, rows.spanHeight);
  }
  context.lineWidth = width;
  context.strokeStyle = colour;
  context.stroke();
}
