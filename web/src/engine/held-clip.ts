/**
 * One clip in a worker: its handle in the core, and what is under way with it. The handle has this one
 * owner, who frees it once.
 */
import type { Core, CoreClip } from './raw';
import { Cancelled } from './turns';

export class HeldClip {
  /** The reading under way, shared by all who wait for the motion. */
  reading: Promise<void> | null = null;
  sha256: string | null = null;
  /** The settings of the results in the core; null while there are none. */
  analysedAs: string | null = null;
  /** Poses of the thumbnails, which outlive the motion: one for each performer. */
  thumbnails: { readonly frame: number; readonly pose: Float32Array<ArrayBuffer> }[] = [];
  private readonly handle: CoreClip;
  private closed = false;
  private users = 0;
  private dropAsked = false;
  private tail: Promise<unknown> = Promise.resolve();

  constructor(core: Core) {
    this.handle = core.newClip();
  }

  /** The handle, as long as the clip is open: to be asked for again after every turn. */
  get core(): CoreClip {
    if (this.closed) throw new Cancelled();
    return this.handle;
  }

  get motionBytes(): number {
    return this.closed ? 0 : this.handle.motionBytes();
  }

  /** Runs work during which the motion stays. */
  async use<T>(work: () => Promise<T>): Promise<T> {
    this.users += 1;
    try {
      return await work();
    } finally {
      this.users -= 1;
      if (this.dropAsked) this.dropMotion();
    }
  }

  /** Runs work after all earlier work of this kind. */
  inTurn<T>(work: () => Promise<T>): Promise<T> {
    const result = this.tail.then(work);
    this.tail = result.catch(() => undefined);
    return result;
  }

  /** Frees the motion, now or when nobody uses it any more. */
  dropMotion(): void {
    this.dropAsked = this.users > 0;
    if (!this.dropAsked && !this.closed) this.handle.dropMotion();
  }

  close(): void {
    if (this.closed) return;
    this.closed = true;
    this.handle.free();
  }
}
