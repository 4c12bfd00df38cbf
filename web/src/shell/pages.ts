/**
 * Which page is chosen in; that one shown out. Compare and Pair are fetched when they are first asked
 * for; what cannot be fetched is told, and tried again at the next visit.
 */
import type { Context } from '../app/context';
import type { Page } from '../app/compare-store';
import { follow } from '../common/mount';
import type { StageSettings } from '../study/mount-stage';
import type { Places } from './layout';

type LatePage = Exclude<Page, 'study'>;
type Mount = (place: HTMLElement, context: Context, settings: StageSettings) => void;

const loaders: Readonly<Record<LatePage, () => Promise<Mount>>> = {
  compare: async () => (await import('../compare/mount-compare')).mountCompare,
  pair: async () => (await import('../pair/mount-pair')).mountPair,
};

export function showPages(places: Places, context: Context, settings: StageSettings): void {
  const asked = new Set<Page>(['study']);
  const load = async (page: LatePage): Promise<void> => {
    asked.add(page);
    try {
      const [mount] = await Promise.all([loaders[page](), context.language.need('sets')]);
      mount(places[page], context, settings);
    } catch (error) {
      asked.delete(page);
      throw error;
    }
  };
  follow(() => {
    const page = context.store.compare.page.value;
    for (const name of ['study', 'compare', 'pair'] as const) places[name].hidden = name !== page;
    // A failure is told by the page's own listener.
    if (page !== 'study' && !asked.has(page)) void load(page);
  });
}
