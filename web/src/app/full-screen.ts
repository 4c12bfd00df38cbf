/**
 * Stage, transport and timeline alone on the whole screen. The page itself becomes full, so that tips,
 * notices and dialogs stay above it; where the browser cannot, its window is filled.
 */
import { signal, type ReadonlySignal } from '@preact/signals-core';

export interface FullScreen {
  readonly active: ReadonlySignal<boolean>;
  readonly toggle: () => void;
}

/** What is used of a document. */
export type Screen = Pick<
  Document,
  'fullscreenElement' | 'fullscreenEnabled' | 'exitFullscreen' | 'addEventListener'
> & { readonly documentElement: Pick<HTMLElement, 'requestFullscreen'> };

export function createFullScreen(page: Screen): FullScreen {
  const active = signal(false);
  const leave = (): void => {
    active.value = false;
    if (page.fullscreenElement) page.exitFullscreen().catch(() => undefined);
  };
  const enter = (): void => {
    active.value = true;
    // Refused: the window is filled.
    if (page.fullscreenEnabled) page.documentElement.requestFullscreen().catch(() => undefined);
  };
  page.addEventListener('fullscreenchange', () => {
    if (!page.fullscreenElement) active.value = false;
  });
  // The browser takes Escape itself while the screen is full.
  page.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && active.peek() && !event.defaultPrevented) leave();
  });
  return { active, toggle: () => (active.peek() ? leave() : enter()) };
}
