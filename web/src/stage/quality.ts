/** In: times between drawn frames. Out: whether to draw with fewer pixels; no three.js. */

const SLOW_MS = 28;
const FAST_MS = 19;
/** Frames in a row that decide: few to step down, many to step up. */
const SLOW_FRAMES = 20;
const FAST_FRAMES = 240;
/** After as many steps down the stage stays down: it would only flicker. */
const MOST_STEPS = 2;

/** Steps down when frames are slow, up again when they are not. */
export class Quality {
  reduced = false;
  private slow = 0;
  private fast = 0;
  private steps = 0;

  /** Time since the previous frame of an unbroken run; true when `reduced` changed. */
  frame(intervalMs: number): boolean {
    this.slow = intervalMs > SLOW_MS ? this.slow + 1 : 0;
    this.fast = intervalMs < FAST_MS ? this.fast + 1 : 0;
    if (!this.reduced && this.slow >= SLOW_FRAMES) return this.change(true);
    if (this.reduced && this.fast >= FAST_FRAMES && this.steps < MOST_STEPS)
      return this.change(false);
    return false;
  }

  private change(reduced: boolean): boolean {
    if (reduced) this.steps++;
    this.reduced = reduced;
    this.slow = this.fast = 0;
    return true;
  }
}
