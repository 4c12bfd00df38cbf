/** Ascending numbers in; which of them lie in a range out. */

/** The elements from index `from` up to, but without, `to`. */
export interface Run {
  readonly from: number;
  readonly to: number;
}

/** The elements within [first, last]. */
export function within(sorted: ArrayLike<number>, first: number, last: number): Run {
  const from = firstIndex(sorted, (value) => value >= first);
  return {
    from,
    to: Math.max(
      from,
      firstIndex(sorted, (value) => value > last),
    ),
  };
}

/** Index of the first element that holds, the elements before it not holding; the length if none. */
function firstIndex(sorted: ArrayLike<number>, holds: (value: number) => boolean): number {
  let low = 0;
  let high = sorted.length;
  while (low < high) {
    const middle = (low + high) >>> 1;
    if (holds(sorted[middle])) high = middle;
    else low = middle + 1;
  }
  return low;
}
