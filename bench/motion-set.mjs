// A large set of motions on the disk. In: a folder, a number of clips. Out: variations of the sample motions,
// below it a folder for each motion; their bytes together.
import { mkdirSync, readdirSync, rmSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { run } from '../scripts/process.mjs';
import { releaseFolder } from './files.mjs';

const program = join(releaseFolder, process.platform === 'win32' ? 'motion-set.exe' : 'motion-set');

const filesIn = (folder) =>
  readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name));

/** `{ folder, clips, bytes }` */
export function motionSet(parent, clips) {
  run('cargo', ['build', '--locked', '--quiet', '--release', '-p', 'bench']);
  const folder = join(parent, `motions-${clips}`);
  mkdirSync(folder, { recursive: true });
  // The clips may have been others in an older version.
  if (filesIn(folder).length !== clips) rmSync(folder, { recursive: true });
  run(program, [folder, String(clips)]);
  const bytes = filesIn(folder).reduce((sum, path) => sum + statSync(path).size, 0);
  return { folder, clips, bytes };
}
