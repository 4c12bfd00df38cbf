/** The pointer over the rows in; the time it leads to and the moment it shows out. */
import type { PairState } from './pair-state';
import { clipAt } from './rows-layout';
import type { TwoSignal } from './mount-rows';

export function listenToRows(area: HTMLElement, state: PairState, two: TwoSignal): void {
  const momentOf = (event: PointerEvent) => {
    const shown = two.peek();
    if (!shown) return null;
    const box = area.getBoundingClientRect();
    const clip = clipAt(event.clientY - box.top);
    return { clip, frame: shown.axes[clip].frameAt(event.clientX - box.left) };
  };
  /** Whose time a drag moves: it stays the one where the drag began. */
  let dragged: 0 | 1 | null = null;
  const drag = (event: PointerEvent): void => {
    const box = area.getBoundingClientRect();
    const axis = dragged === null ? undefined : two.peek()?.axes[dragged];
    if (axis) state.clock.seek(dragged!, axis.frameAt(event.clientX - box.left));
  };
  area.addEventListener('pointerdown', (event) => {
    const onButton = event.target instanceof Element && event.target.closest('button') !== null;
    const moment = momentOf(event);
    if (event.button !== 0 || onButton || !moment) return;
    dragged = moment.clip;
    area.setPointerCapture(event.pointerId);
    state.hovered.value = null;
    drag(event);
  });
  area.addEventListener('pointermove', (event) => {
    if (dragged !== null) drag(event);
    else if (!(event.target instanceof Element && event.target.closest('button')))
      state.hovered.value = momentOf(event);
  });
  for (const end of ['pointerup', 'pointercancel'] as const)
    area.addEventListener(end, () => {
      dragged = null;
    });
  area.addEventListener('pointerleave', () => {
    state.hovered.value = null;
  });
}
