/** A path of dots on a canvas in; the dots painted out. */

/** Fills the current path and strokes its rim. */
export function paintDots(
  context: CanvasRenderingContext2D,
  fill: string,
  rim: string,
  rimWidth: number,
): void {
  context.fillStyle = fill;
  context.strokeStyle = rim;
  context.lineWidth = rimWidth;
  context.fill();
  context.stroke();
}
