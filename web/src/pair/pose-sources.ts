/** Clips in; a source of poses for each out, kept while the clip is on the page, ended when it leaves. */
import { createPoseSource, type PoseSource } from '../engine/pose-source';
import type { Engine } from '../engine/types';
import type { PairClip } from './pair-clips';

export class PoseSources {
  private readonly sources = new Map<PairClip['id'], { clip: PairClip; source: PoseSource }>();

  constructor(private readonly engine: Pick<Engine, 'poseRange'>) {}

  of(clip: PairClip): PoseSource {
    const known = this.sources.get(clip.id);
    if (known?.clip.result === clip.result) return known.source;
    known?.source.destroy();
    const { id, performerIndex, performer, frames } = clip;
    const shape = { jointCount: performer.skeleton.parents.length, frames };
    const source = createPoseSource(this.engine, id, performerIndex, shape);
    this.sources.set(id, { clip, source });
    return source;
  }

  /** Ends the sources of other clips. */
  keep(clips: readonly PairClip[]): void {
    const kept = new Set(clips.map(({ id }) => id));
    for (const [id, { source }] of this.sources) {
      if (kept.has(id)) continue;
      source.destroy();
      this.sources.delete(id);
    }
  }
}
