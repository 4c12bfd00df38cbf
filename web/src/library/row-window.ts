/** Heights and scroll of a list of rows in; which of them have to exist out. */
export interface RowWindow {
  readonly first: number;
  /** One past the last. */
  readonly end: number;
}

/** Rows kept beyond either edge, so that a quick scroll shows no gap. */
const margin = 6;

export function rowWindow(
  count: number,
  rowHeight: number,
  scrollTop: number,
  viewHeight: number,
): RowWindow {
  const first = Math.max(0, Math.floor(scrollTop / rowHeight) - margin);
  const end = Math.min(count, Math.ceil((scrollTop + viewHeight) / rowHeight) + margin);
  return { first: Math.min(first, end), end };
}

/** The last row that begins at or before `y`. */
function rowAt(tops: Float64Array, y: number): number {
  let [low, high] = [0, tops.length - 1];
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if (tops[middle] <= y) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** The same of rows of different heights, by where each begins and the last ends. */
export function unevenWindow(tops: Float64Array, scrollTop: number, viewHeight: number): RowWindow {
  const count = tops.length - 1;
  const first = Math.max(0, rowAt(tops, scrollTop) - margin);
  const end = Math.min(count, rowAt(tops, scrollTop + viewHeight) + 1 + margin);
  return { first: Math.min(first, end), end };
}

/** The scroll that brings a row into view with the least movement. */
export function scrollToRow(
  index: number,
  rowHeight: number,
  scrollTop: number,
  viewHeight: number,
): number {
  return scrollToSpan(index * rowHeight, rowHeight, scrollTop, viewHeight);
}

/** The same of a row that begins at `top`. */
export function scrollToSpan(
  top: number,
  height: number,
  scrollTop: number,
  viewHeight: number,
): number {
  return Math.min(top, Math.max(scrollTop, top + height - viewHeight));
}
