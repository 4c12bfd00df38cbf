/** The engine in; the default of every parameter of the method in the store out, learnt once. */
import type { Engine } from '../engine/types';
import type { Store } from './store';

export function learnDefaults(engine: Pick<Engine, 'methodDefaults'>, store: Store): void {
  engine
    .methodDefaults()
    .then((defaults) => {
      store.defaults.value = defaults;
    })
    // An engine that cannot start says so of the first file that it is given.
    .catch(() => undefined);
}
