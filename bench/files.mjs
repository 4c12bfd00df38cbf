// The files of the benchmark. In: a folder to write into. Out: sets of files by title: the repository's own
// motions, made longer by repeated rows, and recordings where the test data is there.
import { mkdirSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { dataFolder, dataPath } from '../scripts/data.mjs';
import { root, run } from '../scripts/process.mjs';
import { writeLongClip } from './long-clip.mjs';

const extension = process.platform === 'win32' ? '.exe' : '';

/** The long clips repeat this sample. */
const repeated = 'slow-dance-hik-120';

/** The folder of what Cargo builds for release. */
export const releaseFolder = join(process.env.CARGO_TARGET_DIR ?? join(root, 'target'), 'release');

function bvhIn(folder) {
  const names = readdirSync(folder).filter((name) => name.endsWith('.bvh'));
  return names.sort().map((name) => join(folder, name));
}

function writeSamples(folder) {
  run('cargo', ['build', '--locked', '--quiet', '--release', '-p', 'keypose-cli']);
  run(join(releaseFolder, `keypose${extension}`), ['samples', folder]);
  return bvhIn(folder);
}

/** A clip of so many frames; its path. */
export function longClip(folder, sample, frames) {
  const path = join(folder, `frames-${frames}.bvh`);
  writeLongClip(path, readFileSync(sample, 'utf8'), frames);
  return path;
}

function recordings() {
  const data = dataFolder();
  if (data === null) {
    console.log(`no recordings: ${dataPath} (KEYPOSE_DATA) is absent`);
    return [];
  }
  const paths = bvhIn(join(data, 'cmu'));
  const one = (name) => ({ title: `CMU ${name}`, paths: [join(data, 'cmu', `${name}.bvh`)] });
  return [
    one('09_03'),
    one('07_05'),
    one('05_12'),
    { title: `CMU, all ${paths.length} one by one`, paths },
  ];
}

/** `{ sets: [{ title, paths }], long: [path], samples: [path] }`; `frames` are those of the long clips. */
export function benchmarkFiles(folder, frames) {
  mkdirSync(folder, { recursive: true });
  const samples = writeSamples(join(folder, 'samples'));
  const sample = (id) => join(folder, 'samples', `${id}.bvh`);
  const long = frames.map((count) => longClip(folder, sample(repeated), count));
  const sets = [
    { title: 'sample walk, 120 Hz', paths: [sample('walk-poser-120')] },
    { title: 'sample dance, 120 Hz', paths: [sample(repeated)] },
    { title: `samples, all ${samples.length} one by one`, paths: samples },
    ...recordings(),
    ...long.map((path, index) => ({ title: `${frames[index]} frames`, paths: [path] })),
  ];
  return { sets, long, samples };
}
