// Trees over many vectors by Keypose, kodama and SciPy. In: a folder to write into, a number of vectors, a number
// of runs. Out: for each method the milliseconds of each, from the vectors to the tree, in turn; and those of
// every other stage of Keypose's comparing.
import { existsSync, mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { output, root } from '../scripts/process.mjs';
import { releaseFolder } from './files.mjs';
import { spread } from './statistics.mjs';

const isWindows = process.platform === 'win32';
const program = join(releaseFolder, isWindows ? 'comparison.exe' : 'comparison');
const script = join(root, 'bench', 'linkage.py');

/** SciPy's release that is measured against. */
const SCIPY = 'scipy==1.17.1';

/** The sums of the heights agree to so much of them. */
const AGREEMENT = 1e-9;

/** A Python of its own with SciPy; null, saying so, where there can be none. */
function python(folder) {
  const own = isWindows ? join(folder, 'Scripts', 'python.exe') : join(folder, 'bin', 'python');
  const hasScipy = () => output(own, ['-c', 'import scipy']) !== null;
  if (existsSync(own) && hasScipy()) return own;
  const made = ['python3', 'python'].some((name) => output(name, ['-m', 'venv', folder]) !== null);
  if (made) output(own, ['-m', 'pip', 'install', '--quiet', SCIPY]);
  if (made && hasScipy()) return own;
  console.log(`no SciPy: neither found nor to be had (python3 -m venv, pip install ${SCIPY})`);
  return null;
}

function told(command, args) {
  const line = output(command, args, { maxBuffer: 2 ** 26 });
  if (line === null) throw new Error(`${command} ${args.join(' ')} failed`);
  return JSON.parse(line);
}

/** What makes a tree, by name; each a function of the method. */
function makers(folder, count) {
  const path = join(folder, `vectors-${count}.f64`);
  const { width } = told(program, ['vectors', String(count), path]);
  const scipy = python(join(folder, 'python'));
  const native = (name) => (method) => told(program, [name, method, String(count)]);
  return {
    keypose: native('keypose'),
    kodama: native('kodama'),
    ...(scipy && { scipy: (method) => told(scipy, [script, path, String(width), method]) }),
  };
}

function agree(heights, method) {
  const [ours, ...others] = heights;
  if (others.some((other) => Math.abs(other - ours) > AGREEMENT * ours))
    throw new Error(`the trees by ${method} differ: ${heights.join(', ')}`);
}

/** `[{ method, count, keypose, kodama, scipy }]`: spreads in ms; without scipy where it is not there. */
export function measureLinkage(folder, count, runs) {
  mkdirSync(folder, { recursive: true });
  const by = makers(folder, count);
  return ['ward', 'average'].map((method) => {
    const found = Object.fromEntries(Object.keys(by).map((name) => [name, []]));
    for (let run = 0; run < runs; run += 1) {
      const trees = Object.entries(by).map(([name, make]) => [name, make(method)]);
      agree(
        trees.map(([, { heights }]) => heights),
        method,
      );
      for (const [name, { ms }] of trees) found[name].push(ms);
    }
    const spreads = Object.entries(found).map(([name, times]) => [name, spread(times)]);
    return { method, count, ...Object.fromEntries(spreads) };
  });
}

/** `{ count, stages: { name: spread in ms } }` of Keypose alone, on one core. */
export function measureStages(count, runs) {
  const found = told(program, ['stages', String(count), String(runs)]);
  const spreads = Object.entries(found).map(([name, times]) => [name, spread(times)]);
  return { count, stages: Object.fromEntries(spreads) };
}
