// The test data, which is not part of the repository. Out: its folder, or null, saying so.
import { existsSync } from 'node:fs';
import { join } from 'node:path';

const root = join(import.meta.dirname, '..', '..');

/** The folder named by KEYPOSE_DATA, else ../shared/data from the project's root. */
export function dataFolder(): string | null {
  const folder = process.env['KEYPOSE_DATA'] ?? join(root, '..', 'shared', 'data');
  if (existsSync(folder)) return folder;
  process.stderr.write(`skipped: no test data in ${folder} (KEYPOSE_DATA)\n`);
  return null;
}
