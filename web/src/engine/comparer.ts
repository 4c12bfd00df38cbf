/**
 * The comparison's side of the page: features of clips in, promises of what is known of the set out.
 * The worker starts with the second comparable clip.
 */
import { failureOf } from './failures';
import type { Comparer } from './comparison-types';
import { type Engine, EngineError } from './types';

const later = (): Promise<never> =>
  Promise.reject(new EngineError(failureOf('engine-unavailable'), ''));

export function createBrowserComparer(engine: Engine): Comparer {
  void engine;
  return {
    setFeature: () => undefined,
    compare: later,
    cut: later,
    picture: later,
    explain: later,
    neighbours: later,
    evaluate: later,
    warp: later,
    exportFile: later,
    destroy: () => undefined,
  };
}
