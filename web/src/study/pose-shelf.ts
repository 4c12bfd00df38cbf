/** Single poses of a performer in as they come; kept by frame, so that a keypose once seen comes back at once. */
import type { ClipId, Engine } from '../engine/types';

/** Poses kept; the oldest go first. */
const mostPoses = 256;

export class PoseShelf {
  private readonly engine: Pick<Engine, 'poses'>;
  private readonly clip: ClipId;
  private readonly performer: number;
  private readonly poses = new Map<number, Float32Array>();
  private underWay = new AbortController();

  constructor(engine: Pick<Engine, 'poses'>, clip: ClipId, performer: number) {
    this.engine = engine;
    this.clip = clip;
    this.performer = performer;
  }

  /** The poses of all frames, or null while one is missing. */
  read(frames: readonly number[]): readonly Float32Array[] | null {
    const found = frames.map((frame) => this.poses.get(frame));
    return found.every((pose) => pose !== undefined) ? found : null;
  }

  /** Fetches what is missing and tells; a newer wish ends an older one. */
  fetch(frames: readonly number[], onArrive: () => void): void {
    const missing = frames.filter((frame) => !this.poses.has(frame));
    if (missing.length === 0) return;
    this.underWay.abort();
    this.underWay = new AbortController();
    const { signal } = this.underWay;
    this.engine.poses(this.clip, this.performer, Int32Array.from(missing), { signal }).then(
      (values) => {
        if (signal.aborted) return;
        this.keep(missing, values);
        onArrive();
      },
      // The stage goes on without ghosts; a clip that has gone says so itself.
      () => undefined,
    );
  }

  destroy(): void {
    this.underWay.abort();
    this.poses.clear();
  }

  private keep(frames: readonly number[], values: Float32Array): void {
    const { poses } = this;
    const width = values.length / frames.length;
    frames.forEach((frame, i) => poses.set(frame, values.slice(i * width, (i + 1) * width)));
    for (const oldest of poses.keys()) {
      if (poses.size <= mostPoses) break;
      poses.delete(oldest);
    }
  }
}
