/** In: times between drawn frames. Out: whether to draw with less; no three.js. */

const SLOW_MS = 28;
const FAST_MS = 19;
/** Frames in a row that decide: few to step down, many to step up. */
const SLOW_FRAMES = 20;
const FAST_FRAMES = 240;
/** After each step down the way up is longer: the picture must not flicker. */
const PATIENCE = 3;

/** Steps down when frames are slow, up again when they are not. */
export class Quality {
  reduced = false;
  private slow = 0;
  private fast = 0;
  private wait = FAST_FRAMES / PATIENCE;

  /** Time since the previous frame of an unbroken run; true when `reduced` changed. */
  frame(intervalMs: number): boolean {
    this.slow = intervalMs > SLOW_MS ? this.slow + 1 : 0;
    this.fast = intervalMs < FAST_MS ? this.fast + 1 : 0;
    if (!this.reduced && this.slow >= SLOW_FRAMES) return this.change(true);
    if (this.reduced && this.fast >= this.wait) return this.change(false);
    return false;
  }

  private change(reduced: boolean): boolean {
    if (reduced) this.wait *= PATIENCE;
    this.reduced = reduced;
    this.slow = this.fast = 0;
    return true;
  }
}
