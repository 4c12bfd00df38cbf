/**
 * The script of the comparison's worker: loads its core and answers what `comparison-worker.ts` answers.
 */
import { expose } from 'comlink';
import { loadComparisonCore } from './comparison-raw';
import { ComparisonWorker } from './comparison-worker';

expose(new ComparisonWorker(loadComparisonCore()));
