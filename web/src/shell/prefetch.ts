/**
 * What the study needs beyond the first screen, fetched once the page has been painted, its samples stand
 * and nothing else is to be done: the first motion finds it there.
 */
import type { Engine } from '../engine/types';

/** The mark by which `npm run sizes` tells what the first screen needs from what was fetched ahead. */
export const prefetchMark = 'keypose.prefetch';

const whenIdle = (act: () => void): void => {
  if ('requestIdleCallback' in globalThis) requestIdleCallback(act, { timeout: 5000 });
  else setTimeout(act, 200);
};

export function prefetchStudy(engine: Pick<Engine, 'samples'>): void {
  const fetch = (): void => {
    performance.mark(prefetchMark);
    // Without it now, the first motion asks for it and tells.
    import('../stage').catch(() => undefined);
  };
  engine
    .samples()
    .catch(() => undefined)
    .finally(() => whenIdle(fetch));
}
