/** The one horizontal axis that every row of the timeline and the keypose strip share. */

/** Width of the label column left of the axis, in CSS pixels. */
export const GUTTER_WIDTH = 124;
const PADDING_LEFT = 10;
const PADDING_RIGHT = 18;

/** Maps frames of the file (from 0) to pixels right of the gutter, and back. */
export class Axis {
  /**
   * @param width pixels right of the gutter
   * @param lastFrame the last frame of the clip
   */
  constructor(
    readonly width: number,
    readonly lastFrame: number,
  ) {}

  /** Pixels per frame. */
  get scale(): number {
    const inner = Math.max(1, this.width - PADDING_LEFT - PADDING_RIGHT);
    return inner / Math.max(1, this.lastFrame);
  }

  /** The pixel of a frame. */
  x(frame: number): number {
    return PADDING_LEFT + frame * this.scale;
  }

  /** The whole frame nearest to a pixel, within the clip. */
  frameAt(x: number): number {
    const frame = Math.round((x - PADDING_LEFT) / this.scale);
    return Math.min(this.lastFrame, Math.max(0, frame));
  }
}
