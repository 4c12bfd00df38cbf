/** A clip of the library as the page knows it: where it comes from, how far its work is, what it gave. */
import type { ClipFeature } from '../engine/comparison-types';
import type {
  ClipId,
  ClipResult,
  ClipSource,
  Decisions,
  Failure,
  PerformerResult,
} from '../engine/types';
import type { FlatFigure } from '../figure/flat-figure';

/** `surveyed`: one of many, read for its feature; its keyposes follow. */
export type ClipStatus = 'waiting' | 'reading' | 'surveyed' | 'analysing' | 'ready' | 'failed';

/** How long a clip is. */
export type Extent = Pick<ClipResult, 'frames' | 'frameTimeS'>;

export interface Clip {
  /** Also its place in the order of arrival. */
  readonly id: ClipId;
  readonly source: ClipSource;
  readonly status: ClipStatus;
  /** 0 to 1. */
  readonly progress: number;
  readonly result: ClipResult | null;
  /** Known before the result where many clips are read at once. */
  readonly extent: Extent | null;
  /** What it is compared by; null until it is known, and where it cannot be compared. */
  readonly feature: ClipFeature | null;
  /** Why it cannot be compared. */
  readonly incomparable: Failure | null;
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
    extent: null,
    feature: null,
    incomparable: null,
    failure: null,
    thumbnail: null,
    decisions: {},
    outdated: false,
    removed: false,
  };
}

/** Whether nothing is known of the file yet. */
export const isBusy = ({ status }: Clip): boolean =>
  status === 'waiting' || status === 'reading' || status === 'analysing';

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
export function lengthOf({ frames, frameTimeS }: Extent): number {
  return Math.max(0, frames - 1) * frameTimeS;
}

/** Frames of a performer's keyposes, ascending. */
export function keyposeFrames({ keyposes }: PerformerResult): Int32Array {
  return keyposes
    ? keyposes.keyposes.map((candidate) => keyposes.candidates[candidate] ?? 0)
    : new Int32Array();
}
