// The test data, which is not part of the repository. Out: its folder, or null, saying so.
import { dataFolder as presentFolder, dataPath } from '../../scripts/data.mjs';

/** The folder named by KEYPOSE_DATA, else ../shared/data from the project's root. */
export function dataFolder(): string | null {
  const folder = presentFolder();
  if (folder === null)
    process.stderr.write(`skipped: no test data in ${dataPath} (KEYPOSE_DATA)\n`);
  return folder;
}
