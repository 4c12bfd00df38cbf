/** Shades of the body parts in; their strips out, on a canvas, from the ground to the colour of keyposes. */
import { bodyParts } from '../engine/types';
import { prepareCanvas } from '../timeline/canvas';
import type { DifferenceShades } from './difference';
import { partRow, rows } from './rows-layout';

const LEVELS = 64;

export function drawDifference(
  canvas: HTMLCanvasElement,
  { left, columns, shades }: DifferenceShades,
  width: number,
): void {
  const context = prepareCanvas(canvas, width, rows.parts.height);
  canvas.style.width = `${width}px`;
  canvas.style.height = `${rows.parts.height}px`;
  if (!context) return;
  const colours = ramp(canvas);
  for (let part = 0; part < bodyParts.length; part++) {
    const { top, height } = partRow(part);
    let start = 0;
    for (let column = 1; column <= columns; column++) {
      const level = levelOf(shades[part * columns + start]);
      if (column < columns && levelOf(shades[part * columns + column]) === level) continue;
      context.fillStyle = colours[level];
      context.fillRect(left + start, top - rows.parts.top, column - start, height);
      start = column;
    }
  }
}

const levelOf = (shade: number): number => Math.round(shade * (LEVELS - 1));

function ramp(element: Element): string[] {
  const style = getComputedStyle(element);
  const [from, to] = ['--sunken', '--kp'].map((name) => style.getPropertyValue(name).trim());
  return Array.from(
    { length: LEVELS },
    (_, level) => `color-mix(in oklab, ${to} ${(100 * level) / (LEVELS - 1)}%, ${from})`,
  );
}
