/**
 * A panel on the browser's popover and the button it belongs to in; the panel beside the button and in the
 * window out, for as long as it is open, whenever its content comes and whatever changes around it.
 */
import { beside, type Beside } from './beside-layout';

interface KeptBeside extends Beside {
  /** Id of the popover whose button it is. */
  readonly opens: string;
}

const ends = new WeakMap<HTMLElement, AbortController>();

/** Listens to `beforetoggle`: the panel is in its place before it is first seen. */
export function keptBeside(where: KeptBeside): (event: Event) => void {
  return (event) => {
    const panel = event.currentTarget as HTMLElement;
    ends.get(panel)?.abort();
    if ((event as ToggleEvent).newState === 'open') ends.set(panel, keep(panel, where));
  };
}

function keep(panel: HTMLElement, where: KeptBeside): AbortController {
  const end = new AbortController();
  const { signal } = end;
  const button = (): Element | null => document.querySelector(`[popovertarget="${where.opens}"]`);
  const place = (): void => {
    if (!panel.isConnected) return end.abort();
    const box = button()?.getBoundingClientRect();
    if (!box || panel.offsetWidth === 0) return;
    const size = { width: panel.offsetWidth, height: panel.offsetHeight };
    const { left, top } = beside(box, size, { width: innerWidth, height: innerHeight }, where);
    panel.style.left = `${left}px`;
    panel.style.top = `${top}px`;
  };
  // Told between layout and painting: neither a late content nor another language is seen out of place.
  const observer = new ResizeObserver(place);
  for (const one of [panel, button(), document.documentElement]) if (one) observer.observe(one);
  addEventListener('resize', place, { signal });
  addEventListener('scroll', place, { signal, capture: true, passive: true });
  signal.addEventListener('abort', () => observer.disconnect());
  return end;
}
