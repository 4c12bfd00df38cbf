// A page with nothing but the engine and the comparer, for tests: the names below are called from outside.
import { createBrowserComparer } from '../../../web/src/engine/browser-comparer';
import { createBrowserEngine } from '../../../web/src/engine/browser-engine';
import type { Comparer } from '../../../web/src/engine/comparison-types';
import type { Engine } from '../../../web/src/engine/types';
import { comparedBy } from './compared';

declare global {
  interface Window {
    engine: Engine;
    comparer: Comparer;
    comparedBy: typeof comparedBy;
  }
}

window.engine = createBrowserEngine(location.search);
window.comparer = createBrowserComparer(window.engine);
window.comparedBy = comparedBy;
