// The native side. In: paths and a number of runs. Out: for each path the times of the core on one core.
import { join } from 'node:path';
import { output, run } from '../scripts/process.mjs';
import { releaseFolder } from './files.mjs';

const program = join(releaseFolder, process.platform === 'win32' ? 'bench.exe' : 'bench');

/** A map from path to `{ bytes, frames, keyposes, readMs, analyseMs }`. */
export function timeNatively(paths, runs) {
  run('cargo', ['build', '--locked', '--quiet', '--release', '-p', 'bench']);
  const lines = output(program, [String(runs), ...paths], { maxBuffer: 2 ** 26 });
  if (lines === null) throw new Error('the native benchmark failed');
  return new Map(
    lines.split('\n').map((line) => {
      const { path, ...times } = JSON.parse(line);
      return [path, times];
    }),
  );
}
