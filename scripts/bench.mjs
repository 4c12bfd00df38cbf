// `npm run bench`: how fast Keypose reads and extracts, beside three.js in the same page on the same files.
// In: `--long` for an hour of motion too, `--runs N` (default 7). Out: tables, and the same as
// bench/results/latest.json. What is measured how: docs/benchmarks.md.
import { writeFileSync } from 'node:fs';
import { cpus, loadavg } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { servePage } from '../bench/browser.mjs';
import { benchmarkFiles } from '../bench/files.mjs';
import { measureExtraction, measureOpening, measureReading } from '../bench/measure.mjs';
import { timeNatively } from '../bench/native.mjs';
import { report } from '../bench/report.mjs';
import { root } from './process.mjs';

const { values: options } = parseArgs({
  options: { long: { type: 'boolean', default: false }, runs: { type: 'string', default: '7' } },
});
const runs = Number(options.runs);
const frames = [4_500, 45_000, ...(options.long ? [432_000] : [])];
const results = join(root, 'bench', 'results');

/** Runs of a clip: an hour of motion is worked on three times at most. */
const runsOf = (path) => (path.includes('432000') ? Math.min(runs, 3) : runs);

async function inOrder(items, measure) {
  const found = [];
  for (const item of items) found.push(await measure(item));
  return found;
}

function machine() {
  const processors = cpus();
  return {
    processors: processors.length,
    model: processors[0]?.model.trim(),
    load: loadavg()[0],
    node: process.version,
    platform: process.platform,
  };
}

async function measureAll({ sets, long }) {
  const native = timeNatively([...new Set(sets.flatMap(({ paths }) => paths))], runs);
  const page = await servePage();
  const at = page.address;
  try {
    return {
      reading: await inOrder(sets, (set) => measureReading(at, set, native, runsOf(set.paths[0]))),
      extraction: await inOrder(long, (path) => measureExtraction(at, path, native, runsOf(path))),
      opening: await inOrder(long, (path) => measureOpening(at, path, runsOf(path))),
    };
  } finally {
    await page.close();
  }
}

console.log('writing the files');
const files = benchmarkFiles(join(results, 'files'), frames);
console.log('measuring');
const measured = { machine: machine(), runs, ...(await measureAll(files)) };
writeFileSync(join(results, 'latest.json'), `${JSON.stringify(measured, null, 2)}\n`);
console.log(`\n${report(measured)}\n`);
console.log(
  `${measured.machine.processors} × ${measured.machine.model}, load ${measured.machine.load.toFixed(1)}, ` +
    `Chromium ${measured.opening[0]?.chromium}; medians of up to ${runs} runs (minimum–maximum)`,
);
