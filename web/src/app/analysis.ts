/**
 * The work on clips: a clip and its decisions in, its result and thumbnail into the store. A decision
 * waits a moment for the next one; an older run is cancelled by the engine, the old result stays until
 * the new one comes.
 */
import type { ClipId, ClipResult, Decisions, Engine, Progress } from '../engine/types';
import { flatFigure } from '../figure/flat-figure';
import { failureOf, isAbort } from './failure';
import { patchClip, type Store } from './store';

export const settleMs = 150;

export interface Analysis {
  /** Reads and analyses a clip for the first time. */
  readonly open: (id: ClipId, signal: AbortSignal) => Promise<void>;
  /** Analyses a clip again with other decisions. */
  readonly decide: (id: ClipId, decisions: Decisions) => void;
}

export function createAnalysis(
  engine: Engine,
  store: Store,
  onError: (name: string, error: unknown) => void,
): Analysis {
  const timers = new Map<ClipId, ReturnType<typeof setTimeout>>();
  const clipOf = (id: ClipId) => store.clips.peek()[id];

  const drawThumbnail = async (id: ClipId, { performers }: ClipResult): Promise<void> => {
    const performer = performers[0];
    if (!performer) return;
    const pose = await engine.poses(id, 0, Int32Array.of(performer.thumbnailFrame));
    if (clipOf(id)?.result?.performers[0] === performer) {
      patchClip(store, id, { thumbnail: flatFigure(pose, performer, performer.sideYawRad) });
    }
  };

  const accept = (id: ClipId, result: ClipResult): void => {
    patchClip(store, id, { status: 'ready', progress: 1, result, failure: null, outdated: false });
    drawThumbnail(id, result).catch(() => patchClip(store, id, { thumbnail: null }));
  };

  const analyse = async (id: ClipId): Promise<void> => {
    const clip = clipOf(id);
    if (!clip) return;
    try {
      const result = await engine.analyse(id, clip.decisions, {});
      if (clipOf(id)?.decisions === clip.decisions) accept(id, result);
    } catch (error) {
      if (isAbort(error)) return;
      patchClip(store, id, { outdated: false });
      onError(clip.source.name, error);
    }
  };

  return {
    async open(id, signal) {
      const clip = clipOf(id);
      if (!clip) return;
      const onProgress = ({ stage, done }: Progress): void =>
        patchClip(store, id, { status: stage, progress: done });
      try {
        accept(id, await engine.open(id, clip.source, clip.decisions, {}, { signal, onProgress }));
      } catch (error) {
        if (isAbort(error)) throw error;
        patchClip(store, id, { status: 'failed', failure: failureOf(error) });
      }
    },
    decide(id, decisions) {
      patchClip(store, id, { decisions, outdated: true });
      clearTimeout(timers.get(id));
      timers.set(
        id,
        setTimeout(() => void analyse(id), settleMs),
      );
    },
  };
}
