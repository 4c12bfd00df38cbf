/** In: the browser's animation frames. Out: seconds that passed between them. */

/** A page that was hidden or stuck goes on where it was instead of leaping. */
const LONGEST_STEP_S = 0.5;

export class Ticker {
  private request = 0;
  private lastMs: number | null = null;

  private readonly onTick: (dtS: number) => void;

  constructor(onTick: (dtS: number) => void) {
    this.onTick = onTick;
  }

  get running(): boolean {
    return this.request !== 0;
  }

  start(): void {
    if (this.running) return;
    this.lastMs = null;
    this.request = requestAnimationFrame(this.tick);
  }

  stop(): void {
    cancelAnimationFrame(this.request);
    this.request = 0;
  }

  private readonly tick = (nowMs: number): void => {
    this.request = requestAnimationFrame(this.tick);
    const dtS = this.lastMs === null ? 0 : Math.min((nowMs - this.lastMs) / 1000, LONGEST_STEP_S);
    this.lastMs = nowMs;
    if (dtS > 0) this.onTick(dtS);
  };
}
