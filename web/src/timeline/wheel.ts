/** A turn of the wheel over an axis in; what is asked of the part shown out. Pure. */

/** Zooms in by a factor above 1, or pans by pixels; null: neither, the page scrolls. */
export type Turn = { readonly factor: number } | { readonly pan: number } | null;

export type WheelTurn = Pick<
  WheelEvent,
  'ctrlKey' | 'metaKey' | 'shiftKey' | 'deltaX' | 'deltaY' | 'deltaMode'
>;

const ZOOM_PER_PIXEL = 0.003;
const LINE_HEIGHT = 16;
/** A wheel that says pages. */
const PAGE_HEIGHT = 400;

/** With Ctrl (which a pinch on a touchpad sets too) or Meta it zooms, sideways or with Shift it pans. */
export function turnOf(event: WheelTurn): Turn {
  const unit = [1, LINE_HEIGHT, PAGE_HEIGHT][event.deltaMode] ?? 1;
  if (event.ctrlKey || event.metaKey)
    return { factor: Math.exp(-event.deltaY * unit * ZOOM_PER_PIXEL) };
  const sideways = event.shiftKey && event.deltaX === 0 ? event.deltaY : event.deltaX;
  if (!event.shiftKey && Math.abs(sideways) <= Math.abs(event.deltaY)) return null;
  return { pan: sideways * unit };
}
