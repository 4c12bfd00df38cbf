/** A press on a zoom button or key in; what the timeline shows out, the playhead keeping its place. */
import type { Store } from '../app/store';
import { ZOOM_STEP, zoomed } from '../timeline/zoom';

export type Zoom = 'in' | 'out' | 'all';

export function zoom(store: Store, way: Zoom): void {
  const last = (store.openClip.peek()?.result?.frames ?? 1) - 1;
  if (last < 1) return;
  const factor = way === 'in' ? ZOOM_STEP : 1 / ZOOM_STEP;
  store.zoom.value =
    way === 'all' ? null : zoomed(store.span.peek(), last, factor, store.playback.peek().frame);
}
