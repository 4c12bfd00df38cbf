/**
 * Light or dark: what the person chose, else what the system says. The choice stands as `data-theme` on
 * the root element; the tokens follow it.
 */
import { computed, signal, type ReadonlySignal } from '@preact/signals-core';
import type { Preferences } from './preferences';

export type Theme = 'light' | 'dark';
export type ThemeChoice = Theme | 'system';

export interface ThemeState {
  readonly choice: ReadonlySignal<ThemeChoice>;
  readonly theme: ReadonlySignal<Theme>;
  readonly choose: (choice: ThemeChoice) => void;
}

export const themeChoices: readonly ThemeChoice[] = ['system', 'light', 'dark'];

export function createTheme(preferences: Preferences, darkSystem: MediaQueryList): ThemeState {
  const stored = preferences.get('theme');
  const choice = signal<ThemeChoice>(themeChoices.find((known) => known === stored) ?? 'system');
  const system = signal<Theme>(darkSystem.matches ? 'dark' : 'light');
  darkSystem.addEventListener('change', () => {
    system.value = darkSystem.matches ? 'dark' : 'light';
  });
  return {
    choice,
    theme: computed(() => (choice.value === 'system' ? system.value : choice.value)),
    choose(next) {
      choice.value = next;
      preferences.set('theme', next);
    },
  };
}
