/** In: frame count, frame time, the user's commands, passing seconds. Out: the one time of a clip. */

export const MINIMUM_SPEED = 0.1;
export const MAXIMUM_SPEED = 4;
/** The steps that `-` and `+` go through. */
export const SPEED_STEPS: readonly number[] = [0.1, 0.25, 0.5, 0.75, 1, 1.5, 2, 3, 4];

/** Keeps a time that is a frame's own, but for rounding, from falling into the frame before. */
const TINY_FRAMES = 1e-6;

/** The A–B loop, in frames of the file, both included. */
export interface LoopRange {
  readonly a: number;
  readonly b: number;
}

/** The frame shown at a time. */
export function frameAt(timeS: number, frameTimeS: number, frames: number): number {
  return clamp(Math.floor(timeS / frameTimeS + TINY_FRAMES), 0, Math.max(0, frames - 1));
}

/**
 * Time, play, speed and loop of one clip. No timer of its own: `advance` moves it, `onChange` tells
 * of every change. The clip lasts last frame × frame time; without a loop, play ends on the last frame.
 */
export class Clock {
  readonly frames: number;
  readonly frameTimeS: number;
  private time = 0;
  private running = false;
  private rate = 1;
  private range: LoopRange | null = null;
  private looped = false;
  private readonly listeners = new Set<() => void>();

  constructor(clip: { readonly frames: number; readonly frameTimeS: number }) {
    this.frames = clip.frames;
    this.frameTimeS = clip.frameTimeS;
  }

  get timeS(): number {
    return this.time;
  }
  get frame(): number {
    return frameAt(this.time, this.frameTimeS, this.frames);
  }
  get lastFrame(): number {
    return Math.max(0, this.frames - 1);
  }
  get durationS(): number {
    return this.lastFrame * this.frameTimeS;
  }
  get playing(): boolean {
    return this.running;
  }
  get speed(): number {
    return this.rate;
  }
  /** The A–B range, kept while the loop is off; null = the whole clip. */
  get loopRange(): LoopRange | null {
    return this.range;
  }
  get looping(): boolean {
    return this.looped;
  }

  /** Calls back after every change; returns what ends that. */
  onChange(callback: () => void): () => void {
    this.listeners.add(callback);
    return () => this.listeners.delete(callback);
  }

  /** From the end it starts again; from behind the loop, at A. */
  play(): void {
    if (this.running || this.frames < 2) return;
    if (this.time >= this.endS) this.time = this.startS;
    this.running = true;
    this.changed();
  }

  pause(): void {
    if (!this.running) return;
    this.running = false;
    this.changed();
  }

  toggle(): void {
    if (this.running) this.pause();
    else this.play();
  }

  seekTime(timeS: number): void {
    if (!Number.isFinite(timeS)) return;
    this.moveTo(clamp(timeS, 0, this.durationS));
  }

  seekFrame(frame: number): void {
    this.seekTime(Math.round(frame) * this.frameTimeS);
  }

  /** Moves by whole frames, to the frame's own time. */
  step(frames: number): void {
    this.seekFrame(this.frame + frames);
  }

  setSpeed(speed: number): void {
    if (!Number.isFinite(speed)) return;
    const rate = clamp(speed, MINIMUM_SPEED, MAXIMUM_SPEED);
    if (rate === this.rate) return;
    this.rate = rate;
    this.changed();
  }

  /** The next of SPEED_STEPS: 1 faster, -1 slower. */
  stepSpeed(direction: 1 | -1): void {
    const next =
      direction > 0
        ? SPEED_STEPS.find((step) => step > this.rate)
        : SPEED_STEPS.findLast((step) => step < this.rate);
    if (next !== undefined) this.setSpeed(next);
  }

  setLooping(on: boolean): void {
    if (on === this.looped) return;
    this.looped = on;
    this.changed();
  }

  /** Sets A–B and turns the loop on; null clears it. The ends may come in either order. */
  setLoop(range: LoopRange | null): void {
    this.range = range && {
      a: clamp(Math.min(range.a, range.b), 0, this.lastFrame),
      b: clamp(Math.max(range.a, range.b), 0, this.lastFrame),
    };
    this.looped = range !== null;
    this.changed();
  }

  /** A at the current frame; a B before it moves to the end. */
  setLoopStart(): void {
    const a = this.frame;
    const b = this.range?.b ?? this.lastFrame;
    this.setLoop({ a, b: b > a ? b : this.lastFrame });
  }

  /** B at the current frame; an A behind it moves to the start. */
  setLoopEnd(): void {
    const b = this.frame;
    const a = this.range?.a ?? 0;
    this.setLoop({ a: a < b ? a : 0, b });
  }

  /** Lets real seconds pass; does nothing while paused. From behind a loop it goes back to A. */
  advance(dtS: number): void {
    if (!this.running || !(dtS > 0)) return;
    const time = this.time + dtS * this.rate;
    if (this.looped && this.time > this.endS) this.moveTo(this.startS);
    else if (time < this.endS) this.moveTo(time);
    else if (this.looped) this.moveTo(this.wrapped(time));
    else this.finish();
  }

  private get startS(): number {
    return this.looped && this.range ? this.range.a * this.frameTimeS : 0;
  }

  private get endS(): number {
    return this.looped && this.range ? this.range.b * this.frameTimeS : this.durationS;
  }

  private wrapped(time: number): number {
    const length = this.endS - this.startS;
    return length > 0 ? this.startS + ((time - this.startS) % length) : this.startS;
  }

  private finish(): void {
    this.running = false;
    this.time = this.durationS;
    this.changed();
  }

  private moveTo(time: number): void {
    if (time === this.time) return;
    this.time = time;
    this.changed();
  }

  private changed(): void {
    for (const listener of this.listeners) listener();
  }
}

function clamp(value: number, least: number, most: number): number {
  return Math.min(Math.max(value, least), most);
}
