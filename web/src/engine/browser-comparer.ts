/** The comparer of the page: nothing is compared yet. */
import type { PostureSource } from './comparer';
import type { Comparer } from './comparison-types';
import { failureOf } from './failures';
import { EngineError } from './types';

const later = (): Promise<never> =>
  Promise.reject(new EngineError(failureOf('engine-unavailable'), ''));

export function createBrowserComparer(engine: PostureSource): Comparer {
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
