/**
 * Which side panels stand open. Where the window is wide they stand beside the study and stay as the
 * person left them; where it is narrow they are drawers over it, one at a time.
 */
import { computed, signal, type ReadonlySignal, type Signal } from '@preact/signals-core';
import type { Preferences } from './preferences';

export type PanelName = 'library' | 'inspector';

export interface Panel {
  readonly docked: ReadonlySignal<boolean>;
  readonly open: ReadonlySignal<boolean>;
  readonly toggle: () => void;
}

export interface Panels extends Readonly<Record<PanelName, Panel>> {
  readonly drawerOpen: ReadonlySignal<boolean>;
  readonly closeDrawer: () => void;
}

/** The narrowest window in which a panel stands beside the study. */
export const dockedFrom: Readonly<Record<PanelName, number>> = { library: 1024, inspector: 1280 };

function matches(query: MediaQueryList): ReadonlySignal<boolean> {
  const state = signal(query.matches);
  query.addEventListener('change', () => {
    state.value = query.matches;
  });
  return state;
}

function panel(
  name: PanelName,
  docked: ReadonlySignal<boolean>,
  drawer: Signal<PanelName | null>,
  preferences: Preferences,
): Panel {
  const wanted = signal(preferences.get(name) !== 'closed');
  return {
    docked,
    open: computed(() => (docked.value ? wanted.value : drawer.value === name)),
    toggle() {
      if (!docked.peek()) {
        drawer.value = drawer.peek() === name ? null : name;
        return;
      }
      wanted.value = !wanted.peek();
      preferences.set(name, wanted.peek() ? 'open' : 'closed');
    },
  };
}

export function createPanels(
  preferences: Preferences,
  media: (query: string) => MediaQueryList,
): Panels {
  const drawer = signal<PanelName | null>(null);
  const create = (name: PanelName): Panel =>
    panel(name, matches(media(`(min-width: ${dockedFrom[name]}px)`)), drawer, preferences);
  const panels = { library: create('library'), inspector: create('inspector') };
  return {
    ...panels,
    drawerOpen: computed(() => drawer.value !== null && !panels[drawer.value].docked.value),
    closeDrawer() {
      drawer.value = null;
    },
  };
}
