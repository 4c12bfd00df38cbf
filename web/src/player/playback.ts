/**
 * The open clip's clock and the page's commands in; the playback state of the store out. Speed and whether
 * it loops stay as they are from clip to clip.
 */
import type { Store } from '../app/store';
import { Clock, type LoopRange } from './clock';
import { nextAfter, previousBefore } from './neighbours';
import { Ticker } from './ticker';

/** Where a clip is and which part of it loops. */
export interface Place {
  readonly frame: number;
  readonly loop: LoopRange | null;
}

export interface Playback {
  /** The clock of the open clip. */
  readonly clock: Clock;
  /** Starts the clock of another clip, or of the same one at another rate, at a frame. */
  readonly load: (
    clip: { readonly frames: number; readonly frameTimeS: number },
    place: Place,
  ) => void;
  readonly toggle: () => void;
  readonly pause: () => void;
  readonly seek: (frame: number) => void;
  readonly step: (frames: number) => void;
  /** Moves by seconds, by a frame at least. */
  readonly skip: (seconds: number) => void;
  readonly keypose: (direction: 1 | -1) => void;
  readonly toEnd: (direction: 1 | -1) => void;
  readonly speed: (direction: 1 | -1) => void;
  readonly loop: () => void;
  /** A or B of the loop at the playhead. */
  readonly loopEnd: (end: 'a' | 'b') => void;
  readonly setLoop: (range: LoopRange | null) => void;
}

export function createPlayback(store: Store): Playback {
  return new ClockPlayback(store);
}

class ClockPlayback implements Playback {
  clock = new Clock({ frames: 1, frameTimeS: 1 });
  private readonly store: Store;
  private readonly ticker = new Ticker((seconds) => this.clock.advance(seconds));

  constructor(store: Store) {
    this.store = store;
  }

  load(clip: { readonly frames: number; readonly frameTimeS: number }, place: Place): void {
    const { speed, looping } = this.clock;
    this.ticker.stop();
    this.clock = new Clock(clip);
    this.clock.setSpeed(speed);
    if (place.loop) this.clock.setLoop(place.loop);
    this.clock.setLooping(looping);
    this.clock.seekFrame(place.frame);
    this.clock.onChange(() => this.tell());
    this.tell();
  }

  toggle(): void {
    this.clock.toggle();
  }

  pause(): void {
    this.clock.pause();
  }

  seek(frame: number): void {
    this.clock.seekFrame(frame);
  }

  step(frames: number): void {
    this.clock.pause();
    this.clock.step(frames);
  }

  skip(seconds: number): void {
    const frames = Math.round(Math.abs(seconds) / this.clock.frameTimeS);
    this.clock.step(Math.sign(seconds) * Math.max(1, frames));
  }

  keypose(direction: 1 | -1): void {
    const neighbour = direction > 0 ? nextAfter : previousBefore;
    const frame = neighbour(this.store.keyposeFrames.peek(), this.clock.frame);
    if (frame !== null) this.clock.seekFrame(frame);
  }

  toEnd(direction: 1 | -1): void {
    this.clock.seekFrame(direction > 0 ? this.clock.lastFrame : 0);
  }

  speed(direction: 1 | -1): void {
    this.clock.stepSpeed(direction);
  }

  loop(): void {
    this.clock.setLooping(!this.clock.looping);
  }

  loopEnd(end: 'a' | 'b'): void {
    if (end === 'a') this.clock.setLoopStart();
    else this.clock.setLoopEnd();
  }

  setLoop(range: LoopRange | null): void {
    this.clock.setLoop(range);
  }

  private tell(): void {
    const { frame, playing, speed, looping, loopRange: loop } = this.clock;
    if (playing) this.ticker.start();
    else this.ticker.stop();
    const before = this.store.playback.peek();
    const same =
      before.frame === frame &&
      before.playing === playing &&
      before.speed === speed &&
      before.looping === looping &&
      before.loop === loop;
    if (!same) this.store.playback.value = { frame, playing, speed, looping, loop };
  }
}
