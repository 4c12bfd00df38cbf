/** Ends of the A–B loop in, moved by keys or by a pointer; the range out: pure. */
import type { LoopRange } from '../player/clock';

export type LoopEnd = 'a' | 'b';

/** One end of the loop moved to a frame: never onto the other, which stays; past it they change parts. */
export function withEnd(
  range: LoopRange,
  end: LoopEnd,
  frame: number,
  lastFrame: number,
): LoopRange | null {
  const other = end === 'a' ? range.b : range.a;
  const moved = Math.min(lastFrame, Math.max(0, Math.round(frame)));
  if (moved === other) return null;
  return { a: Math.min(moved, other), b: Math.max(moved, other) };
}

/** Where a key takes an end, in frames; null for keys that mean nothing here. */
export function endAfterKey(
  key: string,
  shift: boolean,
  frame: number,
  lastFrame: number,
  tenthFrames: number,
): number | null {
  const step = shift ? Math.max(1, tenthFrames) : 1;
  switch (key) {
    case 'ArrowLeft':
    case 'ArrowDown':
      return frame - step;
    case 'ArrowRight':
    case 'ArrowUp':
      return frame + step;
    case 'Home':
      return 0;
    case 'End':
      return lastFrame;
    default:
      return null;
  }
}
