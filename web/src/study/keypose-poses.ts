/**
 * Frames of which the strip shows a figure in; their poses out, each fetched once, those that are missing
 * in one request at a time.
 */
import { signal } from '@preact/signals-core';
import type { ClipId, Engine } from '../engine/types';

/** Whose poses. */
export interface PoseOwner {
  readonly id: ClipId;
  readonly performer: number;
  readonly jointCount: number;
}

export interface KeyposePoses {
  /** What has arrived, by frame; read within an effect, it is told of more by another object. */
  readonly of: (owner: PoseOwner) => ReadonlyMap<number, Float32Array>;
  readonly want: (owner: PoseOwner, frames: Int32Array) => void;
}

const none: ReadonlyMap<number, Float32Array> = new Map();

const sameOwner = (a: PoseOwner | null, b: PoseOwner): boolean =>
  a?.id === b.id && a.performer === b.performer && a.jointCount === b.jointCount;

export function createKeyposePoses(engine: Pick<Engine, 'poses'>): KeyposePoses {
  return new FetchedPoses(engine);
}

class FetchedPoses implements KeyposePoses {
  private readonly arrived = signal(none);
  private readonly engine: Pick<Engine, 'poses'>;
  private owner: PoseOwner | null = null;
  private abort = new AbortController();
  private underWay = false;
  /** Of what is wanted while a request is under way only the latest counts. */
  private waiting: Int32Array | null = null;

  constructor(engine: Pick<Engine, 'poses'>) {
    this.engine = engine;
  }

  of(owner: PoseOwner): ReadonlyMap<number, Float32Array> {
    const arrived = this.arrived.value;
    return sameOwner(this.owner, owner) ? arrived : none;
  }

  want(owner: PoseOwner, frames: Int32Array): void {
    if (!sameOwner(this.owner, owner)) this.begin(owner);
    if (this.underWay) this.waiting = frames;
    else void this.fetch(owner, frames);
  }

  private begin(owner: PoseOwner): void {
    this.abort.abort();
    this.abort = new AbortController();
    this.owner = owner;
    this.underWay = false;
    this.waiting = null;
    this.arrived.value = none;
  }

  private async fetch(owner: PoseOwner, frames: Int32Array): Promise<void> {
    const missing = frames.filter((frame) => !this.arrived.peek().has(frame));
    if (missing.length === 0) return;
    const { signal } = this.abort;
    this.underWay = true;
    // The strip goes on without figures; a clip that has gone says so itself.
    const poses = await this.engine
      .poses(owner.id, owner.performer, missing, { signal })
      .catch(() => null);
    if (signal.aborted) return;
    this.underWay = false;
    if (poses) this.take(poses, missing, 3 * owner.jointCount);
    const next = this.waiting;
    this.waiting = null;
    if (next) await this.fetch(owner, next);
  }

  private take(poses: Float32Array, frames: Int32Array, width: number): void {
    const all = new Map(this.arrived.peek());
    frames.forEach((frame, index) => {
      const pose = poses.subarray(index * width, (index + 1) * width);
      if (pose.length === width) all.set(frame, pose);
    });
    this.arrived.value = all;
  }
}
