/** The one horizontal axis that every row of the timeline and the keypose strip share. */

/** Width of the label column left of the axis, in CSS pixels. */
export const GUTTER_WIDTH = 124;
const PADDING_LEFT = 10;
const PADDING_RIGHT = 18;

/** The frames between the ends of an axis; they need not be whole. */
export interface AxisSpan {
  readonly first: number;
  readonly last: number;
}

/** Maps frames of the file (from 0) to pixels right of the gutter, and back. */
export class Axis {
  /**
   * @param width pixels right of the gutter
   * @param lastFrame the last frame of the clip
   * @param span the frames shown; by default all
   */
  constructor(
    readonly width: number,
    readonly lastFrame: number,
    readonly span: AxisSpan = { first: 0, last: lastFrame },
  ) {}

  /** Pixels per frame. */
  get scale(): number {
    const inner = Math.max(1, this.width - PADDING_LEFT - PADDING_RIGHT);
    const { first, last } = this.span;
    return inner / (last > first ? last - first : 1);
  }

  /** The pixel of a frame. */
  x(frame: number): number {
    return PADDING_LEFT + (frame - this.span.first) * this.scale;
  }

  /** The place at a pixel, in frames, anywhere. */
  placeAt(x: number): number {
    return this.span.first + (x - PADDING_LEFT) / this.scale;
  }

  /** The whole frame nearest to a pixel, within the clip. */
  frameAt(x: number): number {
    const frame = Math.round(this.placeAt(x));
    return Math.min(this.lastFrame, Math.max(0, frame));
  }
}
