/**
 * Files on their way in; which of them opens by itself out: the first where nothing is open, and if it
 * cannot be read the first that can; and, in the study, a file that was given alone.
 */
import type { ClipId } from '../engine/types';
import { flushClips } from './clip-changes';
import type { Store } from './store';

export interface Opener {
  readonly started: (id: ClipId) => void;
  readonly settled: (id: ClipId, batchSize: number) => void;
  readonly ended: () => void;
}

export function createOpener(store: Store, open: (id: ClipId) => void): Opener {
  /** The clip that nobody chose. */
  let unchosen: ClipId | null = null;
  const openFirstReady = (): void => {
    flushClips(store);
    const ready = store.shown
      .peek()
      .find(({ status }) => status === 'ready' || status === 'surveyed');
    if (ready) open(ready.id);
  };
  const isFailure = (): boolean =>
    store.openClip.peek()?.status === 'failed' && store.openId.peek() === unchosen;
  return {
    started(id) {
      if (store.openClip.peek() !== null) return;
      unchosen = id;
      open(id);
    },
    settled(id, batchSize) {
      // Taken out of the library while it was read.
      if (store.clips.peek()[id]?.removed) return;
      if (batchSize === 1 && store.compare.page.peek() === 'study') open(id);
      else if (isFailure()) openFirstReady();
    },
    ended() {
      if (store.openClip.peek() === null) openFirstReady();
      unchosen = null;
    },
  };
}
