// The test data, which is not part of the repository. Out: its folder, or null where it is absent.
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './process.mjs';

/** Where the test data is looked for: KEYPOSE_DATA, else ../shared/data from the project's root. */
export const dataPath = process.env.KEYPOSE_DATA ?? join(root, '..', 'shared', 'data');

/** The folder of the test data, or null. */
export function dataFolder() {
  return existsSync(dataPath) ? dataPath : null;
}
