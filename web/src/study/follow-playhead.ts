/** The timeline follows the playhead: it turns the page during playback and scrolls to where a key goes. */
import { effect } from '@preact/signals-core';
import type { Span, Store } from '../app/store';
import { paged, revealed } from '../timeline/zoom';

/** A step farther than this, in seconds, was no playing on but a jump. */
const JUMP_S = 0.5;

export interface PlayheadMove {
  readonly before: number;
  readonly frame: number;
  readonly playing: boolean;
  readonly frameTimeS: number;
}

/**
 * The span after the playhead has moved. Whoever looks elsewhere while the motion plays stays there: only a
 * playhead that was in view takes the view along, or one that jumps.
 */
export function followed(span: Span, lastFrame: number, move: PlayheadMove): Span | null {
  const { before, frame, playing, frameTimeS } = move;
  if (!playing) return revealed(span, lastFrame, frame);
  const wasInView = before >= span.first && before <= span.last;
  const jumped = Math.abs(frame - before) * frameTimeS > JUMP_S;
  return wasInView || jumped ? paged(span, lastFrame, frame) : span;
}

export function followPlayhead(store: Store): () => void {
  let before = 0;
  return effect(() => {
    const { frame, playing } = store.playback.value;
    const zoom = store.zoom.peek();
    const result = store.openClip.peek()?.result;
    const move = { before, frame, playing, frameTimeS: result?.frameTimeS ?? 1 };
    const hasMoved = frame !== before;
    before = frame;
    if (zoom === null || !result || !hasMoved) return;
    const after = followed(zoom, result.frames - 1, move);
    if (after?.first !== zoom.first || after.last !== zoom.last) store.zoom.value = after;
  });
}
