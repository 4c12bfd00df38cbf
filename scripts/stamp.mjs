// Stamps: what a step was done from, so that it is done again only when that changed.
// In: files, folders and words. Out: one hash. Node built-ins only.
import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import { root } from './process.mjs';

/** All files at or under the paths, which start at the project's root; sorted. */
function filesUnder(paths) {
  const found = paths.flatMap((path) => {
    const absolute = join(root, path);
    if (!statSync(absolute).isDirectory()) return [absolute];
    return readdirSync(absolute, { recursive: true, withFileTypes: true })
      .filter((entry) => entry.isFile())
      .map((entry) => join(entry.parentPath ?? entry.path, entry.name));
  });
  return found.sort();
}

/** The hash of the names and bytes of all files at or under `paths`, and of `words`. */
export function hashOf(paths, words = []) {
  const hash = createHash('sha256');
  for (const word of words) hash.update(`${word}\0`);
  for (const file of filesUnder(paths)) {
    hash.update(`${relative(root, file).split(sep).join('/')}\0`);
    hash.update(readFileSync(file));
  }
  return hash.digest('hex').slice(0, 16);
}

/** Whether the stamp file holds `hash`. */
export function isStamped(file, hash) {
  try {
    return readFileSync(file, 'utf8') === hash;
  } catch {
    return false;
  }
}

/** Writes `hash` into the stamp file. */
export function stamp(file, hash) {
  writeFileSync(file, hash);
}
