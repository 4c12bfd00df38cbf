/** The page that is shown in; a step of the browser's history for each out: Back leads to the page before, not away. */
import { effect, type Signal } from '@preact/signals-core';
import type { Page } from '../app/compare-store';

const pages: readonly unknown[] = ['study', 'compare', 'pair'];

const pageIn = (state: unknown): unknown => (state as { page?: unknown } | null)?.page;

export function followHistory(page: Signal<Page>, { history }: Window = window): void {
  // After a reload there are no clips, and Study is the page of the first ones.
  history.replaceState({ page: page.peek() }, '');
  effect(() => {
    if (pageIn(history.state) !== page.value) history.pushState({ page: page.value }, '');
  });
  addEventListener('popstate', ({ state }) => {
    const earlier = pageIn(state);
    if (pages.includes(earlier)) page.value = earlier as Page;
  });
}
