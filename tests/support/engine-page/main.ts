// A page with nothing but the engine, for tests: the names below are called from outside.
import { createBrowserEngine } from '../../../web/src/engine/browser-engine';
import type { Engine } from '../../../web/src/engine/types';

declare global {
  interface Window {
    engine: Engine;
  }
}

window.engine = createBrowserEngine(location.search);
