/** A panel whose inner edge can be dragged, or moved by the arrow keys, within limits; double-click resets. */
import type { Preferences } from '../app/preferences';

export interface Splitter {
  readonly panel: HTMLElement;
  /** Which edge of the panel moves. */
  readonly edge: 'left' | 'right';
  readonly property: string;
  readonly usual: number;
  readonly least: number;
  readonly most: number;
}

const keyStepPx = 16;

function createHandle({ edge, least, most }: Splitter): HTMLElement {
  const handle = document.createElement('div');
  handle.className = `splitter ${edge}`;
  handle.tabIndex = 0;
  handle.setAttribute('role', 'separator');
  handle.setAttribute('aria-orientation', 'vertical');
  handle.setAttribute('aria-valuemin', String(least));
  handle.setAttribute('aria-valuemax', String(most));
  return handle;
}

function listen(handle: HTMLElement, splitter: Splitter, set: (width: number) => void): void {
  const { panel, edge, usual } = splitter;
  const outward = edge === 'right' ? 1 : -1;
  handle.addEventListener('pointerdown', (event) => {
    if (event.button === 0) handle.setPointerCapture(event.pointerId);
  });
  handle.addEventListener('pointermove', (event) => {
    if (!handle.hasPointerCapture(event.pointerId)) return;
    const box = panel.getBoundingClientRect();
    set(edge === 'right' ? event.clientX - box.left : box.right - event.clientX);
  });
  handle.addEventListener('dblclick', () => set(usual));
  handle.addEventListener('keydown', (event) => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!step) return;
    event.preventDefault();
    set(panel.offsetWidth + step * outward * keyStepPx);
  });
}

/** Puts the handle on the panel; the width is remembered. */
export function installSplitter(splitter: Splitter, preferences: Preferences): HTMLElement {
  const { panel, property, usual, least, most } = splitter;
  const handle = createHandle(splitter);
  const set = (width: number): void => {
    const within = Math.round(Math.min(Math.max(width, least), most));
    document.documentElement.style.setProperty(property, `${within}px`);
    handle.setAttribute('aria-valuenow', String(within));
    preferences.set(property, String(within));
  };
  const stored = Number(preferences.get(property) ?? Number.NaN);
  set(Number.isFinite(stored) ? stored : usual);
  listen(handle, splitter, set);
  panel.append(handle);
  return handle;
}
