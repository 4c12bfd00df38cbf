// The command over a folder. In: sample motions, a folder to fill. Out: how many MB and clips a second and
// core `keypose keyposes DIR` does.
import { mkdirSync, readdirSync, statSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { basename, join } from 'node:path';
import { output } from '../scripts/process.mjs';
import { releaseFolder } from './files.mjs';
import { namesake } from './app.mjs';
import { spread } from './statistics.mjs';
import { copyFileSync, existsSync } from 'node:fs';

const command = join(releaseFolder, process.platform === 'win32' ? 'keypose.exe' : 'keypose');

/** A folder of so many clips: the samples, again and again. */
function fill(folder, samples, count) {
  mkdirSync(folder, { recursive: true });
  for (let number = 0; number < count; number += 1) {
    const sample = samples[number % samples.length];
    const first = join(folder, basename(sample));
    if (!existsSync(first)) copyFileSync(sample, first);
    if (number >= samples.length) namesake(first, number);
  }
  return readdirSync(folder).map((name) => join(folder, name));
}

/** MB/s and clips/s of one core, over `count` clips. */
export function measureFolder(folder, samples, count, runs) {
  const paths = fill(folder, samples, count);
  const bytes = paths.reduce((sum, path) => sum + statSync(path).size, 0);
  const cores = availableParallelism();
  const seconds = Array.from({ length: runs }, () => {
    const start = performance.now();
    const lines = output(command, ['keyposes', folder], { maxBuffer: 2 ** 28 });
    if (lines?.split('\n').length !== count) throw new Error('the command did not do every clip');
    return (performance.now() - start) / 1e3;
  });
  return {
    clips: count,
    bytes,
    cores,
    megabytesPerSecond: spread(seconds.map((one) => bytes / 1e6 / one / cores)),
    clipsPerSecond: spread(seconds.map((one) => count / one / cores)),
  };
}
