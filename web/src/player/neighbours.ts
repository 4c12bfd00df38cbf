/** In: frames of keyposes or marks, ascending, and a frame. Out: the next, the previous, the nearest. */

/** The first frame strictly later, or null: no wrap. */
export function nextAfter(frames: ArrayLike<number>, frame: number): number | null {
  return frames[firstIndex(frames, (other) => other > frame)] ?? null;
}

/** The last frame strictly earlier, or null: no wrap. */
export function previousBefore(frames: ArrayLike<number>, frame: number): number | null {
  return frames[firstIndex(frames, (other) => other >= frame) - 1] ?? null;
}

/** Index of the frame nearest to `frame`, on a tie the earlier; null if there is none. */
export function nearestIndex(frames: ArrayLike<number>, frame: number): number | null {
  if (frames.length === 0) return null;
  const later = firstIndex(frames, (other) => other >= frame);
  if (later === 0) return 0;
  if (later === frames.length) return later - 1;
  return frames[later] - frame < frame - frames[later - 1] ? later : later - 1;
}

/** Index of the first element that holds, the elements before it not holding; the length if none. */
function firstIndex(frames: ArrayLike<number>, holds: (frame: number) => boolean): number {
  let low = 0;
  let high = frames.length;
  while (low < high) {
    const middle = (low + high) >>> 1;
    if (holds(frames[middle])) high = middle;
    else low = middle + 1;
  }
  return low;
}
