/**
 * The clips of a pair, their alignment, commands and passing seconds in; one time and every clip's frame
 * out. No timer of its own.
 */
import { Clock, frameAt } from '../player/clock';
import { nextAfter, previousBefore } from '../player/neighbours';
import { alignedByStart, type Alignment, type ClipLength } from './alignment';

export interface PairMoment {
  /** The pair's own time. */
  readonly pairS: number;
  /** Of each clip. */
  readonly frames: readonly number[];
  readonly playing: boolean;
  readonly speed: number;
  readonly looping: boolean;
  /** null: all of it. */
  readonly loop: PairLoop | null;
}

/** A–B in the pair's own time. */
export interface PairLoop {
  readonly fromS: number;
  readonly toS: number;
}

/** Steps of the pair's own time in the shortest frame of a clip. */
const STEPS_PER_FRAME = 4;
const MOST_STEPS = 4e6;
/** Moments nearer than this are one. */
const SAME_S = 1e-6;

export class PairClock {
  private clips: readonly ClipLength[] = [];
  private alignment: Alignment = alignedByStart([]);
  private clock = new Clock({ frames: 1, frameTimeS: 1 });
  private endListening = (): void => undefined;

  constructor(private readonly onChange: () => void) {}

  /**
   * Other clips or another alignment, A at a moment, by default where it is; speed and looping stay, and the
   * moments of A between which it loops where A is the same clip.
   */
  load(
    clips: readonly ClipLength[],
    alignment: Alignment,
    timeA = this.timeOf(0),
    isSameA = false,
  ): void {
    const { speed, looping, playing } = this.clock;
    const loop = isSameA ? this.loop : null;
    const again = (pairS: number): number =>
      alignment.pairTimeOf(0, this.alignment.timeOf(0, pairS));
    const loopAgain = loop && { fromS: again(loop.fromS), toS: again(loop.toS) };
    this.endListening();
    this.clips = clips;
    this.alignment = alignment;
    this.clock = new Clock(stepsOf(clips, alignment.durationS));
    this.clock.setSpeed(speed);
    this.setLoop(loopAgain);
    this.clock.setLooping(looping);
    this.clock.seekTime(alignment.pairTimeOf(0, timeA));
    if (playing) this.clock.play();
    this.endListening = this.clock.onChange(this.onChange);
    this.onChange();
  }

  get playing(): boolean {
    return this.clock.playing;
  }

  moment(): PairMoment {
    const { timeS, playing, speed, looping } = this.clock;
    return {
      pairS: timeS,
      frames: this.clips.map((_, clip) => this.frameOf(clip)),
      playing,
      speed,
      looping,
      loop: this.loop,
    };
  }

  private get loop(): PairLoop | null {
    const { loopRange, frameTimeS } = this.clock;
    return loopRange && { fromS: loopRange.a * frameTimeS, toS: loopRange.b * frameTimeS };
  }

  frameOf(clip: number): number {
    const { frames, frameTimeS } = this.clips[clip] ?? { frames: 1, frameTimeS: 1 };
    return frameAt(this.timeOf(clip), frameTimeS, frames);
  }

  advance(seconds: number): void {
    this.clock.advance(seconds);
  }

  toggle(): void {
    this.clock.toggle();
  }

  pause(): void {
    this.clock.pause();
  }

  /** Goes where a clip is at a frame. */
  seek(clip: number, frame: number): void {
    const frameTimeS = this.clips[clip]?.frameTimeS ?? 1;
    this.clock.seekTime(this.alignment.pairTimeOf(clip, frame * frameTimeS));
  }

  /** By a frame of A; where A stands still, by a frame of another clip. */
  step(direction: 1 | -1): void {
    this.clock.pause();
    const now = this.clock.timeS;
    for (let clip = 0; clip < this.clips.length; clip++) {
      const { frames, frameTimeS } = this.clips[clip];
      const frame = this.frameOf(clip) + direction;
      if (frame < 0 || frame >= frames) continue;
      const then = this.alignment.pairTimeOf(clip, frame * frameTimeS);
      if ((then - now) * direction <= SAME_S) continue;
      this.clock.seekTime(then);
      return;
    }
  }

  skip(seconds: number): void {
    this.clock.seekTime(this.clock.timeS + seconds);
  }

  /** To the next or previous keypose of a clip; no wrap. */
  keypose(clip: number, keyposes: Int32Array, direction: 1 | -1): void {
    const neighbour = direction > 0 ? nextAfter : previousBefore;
    const frame = neighbour(keyposes, this.frameOf(clip));
    if (frame !== null) this.seek(clip, frame);
  }

  toEnd(direction: 1 | -1): void {
    this.clock.seekTime(direction > 0 ? this.clock.durationS : 0);
  }

  setSpeed(speed: number): void {
    this.clock.setSpeed(speed);
  }

  stepSpeed(direction: 1 | -1): void {
    this.clock.stepSpeed(direction);
  }

  toggleLoop(): void {
    this.clock.setLooping(!this.clock.looping);
  }

  loopEnd(end: 'a' | 'b'): void {
    if (end === 'a') this.clock.setLoopStart();
    else this.clock.setLoopEnd();
  }

  /** Turns the loop on; null clears it, and so does one without length. */
  setLoop(loop: PairLoop | null): void {
    const { frameTimeS } = this.clock;
    const range = loop && { a: loop.fromS / frameTimeS, b: loop.toS / frameTimeS };
    this.clock.setLoop(range && range.b - range.a > SAME_S ? range : null);
  }

  timeOf(clip: number): number {
    return this.alignment.timeOf(clip, this.clock.timeS);
  }
}

/** The pair's own time in steps so fine that every frame of every clip is met. */
function stepsOf(clips: readonly ClipLength[], durationS: number): ClipLength {
  const shortest = Math.min(...clips.map(({ frameTimeS }) => frameTimeS));
  const wanted = Math.ceil((durationS / shortest) * STEPS_PER_FRAME);
  if (!(wanted > 0)) return { frames: 1, frameTimeS: 1 };
  const steps = Math.min(wanted, MOST_STEPS);
  return { frames: steps + 1, frameTimeS: durationS / steps };
}
