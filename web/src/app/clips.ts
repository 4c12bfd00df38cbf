/** A clip of the library as the page knows it: where it comes from, how far its work is, what it gave. */
import type {
  ClipId,
  ClipResult,
  ClipSource,
  Decisions,
  Failure,
  PerformerResult,
} from '../engine/types';
import type { FlatFigure } from '../figure/flat-figure';

export type ClipStatus = 'waiting' | 'reading' | 'analysing' | 'ready' | 'failed';

export interface Clip {
  /** Also its place in the order of arrival. */
  readonly id: ClipId;
  readonly source: ClipSource;
  readonly status: ClipStatus;
  /** 0 to 1. */
  readonly progress: number;
  readonly result: ClipResult | null;
  readonly failure: Failure | null;
  /** The figure of the first performer's most unusual keypose. */
  readonly thumbnail: FlatFigure | null;
  readonly decisions: Decisions;
  /** A decision has been made that the result does not know yet. */
  readonly outdated: boolean;
  /** Out of the library; undo brings it back. */
  readonly removed: boolean;
}

export function newClip(id: ClipId, source: ClipSource): Clip {
  return {
    id,
    source,
    status: 'waiting',
    progress: 0,
    result: null,
    failure: null,
    thumbnail: null,
    decisions: {},
    outdated: false,
    removed: false,
  };
}

export const isBusy = ({ status }: Clip): boolean => status !== 'ready' && status !== 'failed';

/** The keyposes of all performers. */
export function keyposeCount({ result }: Clip): number {
  return (result?.performers ?? []).reduce(
    (sum, { keyposes }) => sum + (keyposes?.keyposes.length ?? 0),
    0,
  );
}

/** Whether keyposes could be looked for at all. */
export function isAnalysed({ result }: Clip): boolean {
  return result?.performers.some(({ keyposes }) => keyposes !== null) ?? false;
}

/** Seconds from the first to the last frame. */
export function lengthOf({ frames, frameTimeS }: ClipResult): number {
  return Math.max(0, frames - 1) * frameTimeS;
}

/** Frames of a performer's keyposes, ascending. */
export function keyposeFrames({ keyposes }: PerformerResult): Int32Array {
  return keyposes
    ? keyposes.keyposes.map((candidate) => keyposes.candidates[candidate] ?? 0)
    : new Int32Array();
}

/** Whether two sources are the same file, given twice. */
export function isSameSource(a: ClipSource, b: ClipSource): boolean {
  const sameName = a.name === b.name && a.folder === b.folder && a.blob.size === b.blob.size;
  if (!sameName || !(a.blob instanceof File) || !(b.blob instanceof File)) return sameName;
  return a.blob.lastModified === b.blob.lastModified;
}
