/** Single poses of a performer in as they come; kept by frame, so that a keypose once seen comes back at once. */
import type { ClipId, Engine } from '../engine/types';

/** Poses kept; the oldest go first. */
const mostPoses = 256;

export interface PoseShelf {
  /** The poses of all frames, or null while one is missing. */
  readonly read: (frames: readonly number[]) => readonly Float32Array[] | null;
  /** Fetches what is missing and tells; a newer wish ends an older one. */
  readonly fetch: (frames: readonly number[], onArrive: () => void) => void;
  readonly destroy: () => void;
}

export function createPoseShelf(
  engine: Pick<Engine, 'poses'>,
  clip: ClipId,
  performer: number,
): PoseShelf {
  const poses = new Map<number, Float32Array>();
  let underWay = new AbortController();

  const keep = (frames: readonly number[], values: Float32Array): void => {
    const width = values.length / frames.length;
    frames.forEach((frame, i) => poses.set(frame, values.slice(i * width, (i + 1) * width)));
    for (const oldest of poses.keys()) {
      if (poses.size <= mostPoses) break;
      poses.delete(oldest);
    }
  };
  return {
    read(frames) {
      const found = frames.map((frame) => poses.get(frame));
      return found.every((pose) => pose !== undefined) ? found : null;
    },
    fetch(frames, onArrive) {
      const missing = frames.filter((frame) => !poses.has(frame));
      if (missing.length === 0) return;
      underWay.abort();
      underWay = new AbortController();
      const { signal } = underWay;
      engine.poses(clip, performer, Int32Array.from(missing), { signal }).then(
        (values) => {
          if (signal.aborted) return;
          keep(missing, values);
          onArrive();
        },
        // The stage goes on without ghosts; a clip that has gone says so itself.
        () => undefined,
      );
    },
    destroy() {
      underWay.abort();
      poses.clear();
    },
  };
}
