/** Clips in; their poses for a film out: exactly those of a moment, waited for. */
import type { Context } from '../app/context';
import { createPoseSource, type PoseSource } from '../engine/pose-source';
import type { StageGhost, StageTrails } from '../stage';
import type { PairClip } from './pair-clips';
import { framesOfTrails, keyposesAround } from './stage-moments';

type Engine = Pick<Context['engine'], 'poses' | 'poseRange'>;

/** What stands around a clip while one keypose is the nearest. */
export interface Surroundings {
  readonly current: number | null;
  readonly ghosts: readonly StageGhost[];
  readonly trails: StageTrails | null;
}

export class FilmPoses {
  private readonly sources = new Map<PairClip, PoseSource>();
  private readonly abort = new AbortController();
  private fail: (error: unknown) => void = () => undefined;
  /** Rejects with what keeps poses from coming. */
  private readonly failed = new Promise<never>((_, reject) => {
    this.fail = reject;
  });

  constructor(private readonly engine: Engine) {
    this.failed.catch(() => undefined);
  }

  of(clip: PairClip): PoseSource {
    const known = this.sources.get(clip);
    if (known) return known;
    const { id, performerIndex, performer, frames } = clip;
    const shape = { jointCount: performer.skeleton.parents.length, frames };
    const onError = (error: unknown): void => this.fail(error);
    const source = createPoseSource(this.engine, id, performerIndex, shape, { onError });
    this.sources.set(clip, source);
    return source;
  }

  /** Until a frame's pose can be read. */
  async there(clip: PairClip, frame: number): Promise<void> {
    const source = this.of(clip);
    source.prefetch(frame, 1);
    if (source.read(frame)) return;
    const arrived = new Promise<void>((resolve) => {
      const end = source.onArrive(() => {
        if (!source.read(frame)) return;
        end();
        resolve();
      });
    });
    await Promise.race([arrived, this.failed]);
  }

  /** `together`: clips on the stage. */
  async around(
    clip: PairClip,
    current: number | null,
    wish: { readonly keyposes: boolean; readonly trails: boolean },
    together: number,
  ): Promise<Surroundings> {
    const moments = wish.keyposes ? keyposesAround(clip.keyposes, current, together) : [];
    const frames = wish.trails ? framesOfTrails(clip, current) : null;
    const [poses, trails] = await Promise.all([
      this.poses(
        clip,
        Int32Array.from(moments, ({ frame }) => frame),
      ),
      frames && this.poses(clip, frames),
    ]);
    const width = poses.length / Math.max(1, moments.length);
    return {
      current,
      ghosts: moments.map(({ number }, i) => ({
        tag: String(number),
        pose: poses.slice(i * width, (i + 1) * width),
      })),
      trails: frames && trails && { joints: clip.performer.trailJoints, frames, poses: trails },
    };
  }

  destroy(): void {
    this.abort.abort();
    for (const source of this.sources.values()) source.destroy();
  }

  private async poses(clip: PairClip, frames: Int32Array): Promise<Float32Array> {
    if (frames.length === 0) return new Float32Array();
    const { signal } = this.abort;
    return this.engine.poses(clip.id, clip.performerIndex, frames, { signal });
  }
}
