/**
 * The work on clips: a clip and its decisions in, its result and thumbnail into the store. A decision
 * waits a moment for the next one; an older run is cancelled by the engine, the old result stays until
 * the new one comes.
 */
import type {
  ClipId,
  ClipResult,
  Decisions,
  Engine,
  MethodOptions,
  Progress,
} from '../engine/types';
import { flatFigure, type FlatFigure } from '../figure/flat-figure';
import { clipNow, flushClips, patchClip, patchClipSoon } from './clip-changes';
import type { Clip } from './clips';
import { comparableOf } from './comparable';
import { failureOf, isAbort } from './failure';
import { inheritedJoints } from './joint-choices';
import type { Store } from './store';

export const settleMs = 150;

/** The name under which the browser's timeline notes that a clip's keyposes are known. */
const keyposesMark = 'keyposes';

export interface Analysis {
  /** Reads and analyses a clip for the first time. */
  readonly open: (id: ClipId, signal: AbortSignal) => Promise<void>;
  /** Analyses a clip again with other decisions. */
  readonly decide: (id: ClipId, decisions: Decisions) => void;
  /** Analyses every clip again with other parameters, the open one first. */
  readonly setOptions: (options: MethodOptions) => void;
}

type TellError = (name: string, error: unknown) => void;

export function createAnalysis(engine: Engine, store: Store, tellError: TellError): Analysis {
  return new ClipAnalysis(engine, store, tellError);
}

class ClipAnalysis implements Analysis {
  private readonly engine: Engine;
  private readonly store: Store;
  private readonly tellError: TellError;
  private optionsTimer: ReturnType<typeof setTimeout> | undefined;
  private readonly timers = new Map<ClipId, ReturnType<typeof setTimeout>>();

  constructor(engine: Engine, store: Store, tellError: TellError) {
    this.engine = engine;
    this.store = store;
    this.tellError = tellError;
  }

  async open(id: ClipId, signal: AbortSignal): Promise<void> {
    const clip = this.clipOf(id);
    if (!clip) return;
    const { options } = this.store;
    const begunWith = options.peek();
    const onProgress = ({ stage, done }: Progress): void =>
      this.patch(id, { status: stage, progress: done });
    try {
      const work = { signal, onProgress };
      const result = await this.engine.open(id, clip.source, clip.decisions, begunWith, work);
      const joints = inheritedJoints(this.store.clips.peek(), result);
      const taken = joints && !clip.decisions.joints ? { ...clip.decisions, joints } : null;
      this.accept(id, result);
      if (taken || options.peek() !== begunWith) this.decide(id, taken ?? clip.decisions);
    } catch (error) {
      if (isAbort(error)) throw error;
      this.patch(id, { status: 'failed', failure: failureOf(error) });
    }
  }

  decide(id: ClipId, decisions: Decisions): void {
    patchClip(this.store, id, { decisions, outdated: true });
    clearTimeout(this.timers.get(id));
    this.timers.set(
      id,
      setTimeout(() => void this.analyse(id), settleMs),
    );
  }

  setOptions(options: MethodOptions): void {
    flushClips(this.store);
    const analysed = this.store.clips.peek().filter(({ result }) => result !== null);
    this.store.options.value = options;
    this.store.clips.value = this.store.clips
      .peek()
      .map((clip) => (clip.result === null ? clip : { ...clip, outdated: true }));
    clearTimeout(this.optionsTimer);
    this.optionsTimer = setTimeout(() => {
      const openId = this.store.openId.peek();
      const ids = analysed
        .map(({ id }) => id)
        .sort((a, b) => Number(b === openId) - Number(a === openId));
      for (const id of ids) void this.analyse(id);
    }, settleMs);
  }

  private async analyse(id: ClipId): Promise<void> {
    const clip = this.clipOf(id);
    if (!clip) return;
    try {
      const options = this.store.options.peek();
      const result = await this.engine.analyse(id, clip.decisions, options);
      const isCurrent =
        this.clipOf(id)?.decisions === clip.decisions && this.store.options.peek() === options;
      if (isCurrent) this.accept(id, result);
    } catch (error) {
      if (isAbort(error)) return;
      patchClip(this.store, id, { outdated: false });
      this.tellError(clip.source.name, error);
    }
  }

  private accept(id: ClipId, result: ClipResult): void {
    this.patch(id, {
      status: 'ready',
      progress: 1,
      failure: null,
      outdated: false,
      result,
      extent: result,
      thumbnail: thumbnailOf(result),
      ...comparableOf(result, this.clipOf(id)?.feature ?? null),
    });
    performance.mark(keyposesMark, { detail: id });
  }

  /** The open clip is shown at once; the others when the list is made anew. */
  private patch(id: ClipId, fields: Partial<Clip>): void {
    if (id === this.store.openId.peek()) patchClip(this.store, id, fields);
    else patchClipSoon(this.store, id, fields);
  }

  private clipOf(id: ClipId): Clip | undefined {
    return clipNow(this.store, id);
  }
}

function thumbnailOf({ performers, thumbnailPose }: ClipResult): FlatFigure | null {
  const [performer] = performers;
  if (!performer || thumbnailPose.length === 0) return null;
  return flatFigure(thumbnailPose, performer, performer.sideYawRad);
}
