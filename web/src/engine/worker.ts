/**
 * The script of a worker: loads the core and answers what `clip-worker.ts` answers.
 */
import { expose } from 'comlink';
import { ClipWorker } from './clip-worker';
import { loadCore } from './raw';

// Exposed before the core is there: messages that come while it loads are answered after.
expose(new ClipWorker(loadCore()));
