/**
 * Labels, scroll and room of a confusion matrix in; the part of it that stands in sight out. Of many labels
 * only that part exists; it moves by whole fields, under its heads.
 */
export interface Room {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

export interface ConfusionWindow {
  readonly firstRow: number;
  readonly rowCount: number;
  readonly firstColumn: number;
  readonly columnCount: number;
}

/** A field, with the gap to the next. */
export const fieldPx = { width: 26, height: 21 } as const;
/** The labels before the rows and over the columns. */
export const headPx = { width: 102, height: 18 } as const;
/** Up to here all of it is drawn, as wide as its words. */
export const mostWhole = 24;

/** At most; where it is less, the last field is reached a little before the end. */
const scrollBarPx = 16;
const spareFields = 2;

const span = (count: number, size: number, scroll: number, room: number): [number, number] => {
  const shown = Math.min(count, Math.max(1, Math.floor((room - scrollBarPx) / size)));
  return [Math.max(0, Math.min(count - shown, Math.round(scroll / size))), shown];
};

export function confusionWindow(labels: number, room: Room): ConfusionWindow {
  if (labels <= mostWhole)
    return { firstRow: 0, rowCount: labels, firstColumn: 0, columnCount: labels };
  const { width, height } = fieldPx;
  const [firstRow, rowCount] = span(labels, height, room.top, room.height - headPx.height);
  const [firstColumn, columnCount] = span(labels, width, room.left, room.width - headPx.width);
  return { firstRow, rowCount, firstColumn, columnCount };
}

/** The whole, as it would be drawn; what is scrolled over. */
export const confusionExtent = (labels: number): { width: number; height: number } => ({
  width: headPx.width + (labels + spareFields) * fieldPx.width,
  height: headPx.height + (labels + spareFields) * fieldPx.height,
});
