// `npm run bench`: how fast Keypose reads, extracts, opens, draws and compares, beside three.js in the same page on
// the same files and beside other programs that make trees. In: `--short` leaves the hour of motion out, `--runs N`
// (default 7), `--clips N` (3000) and `--vectors N` (10000) to compare, `--only PART…`. Out: tables, and the same
// as bench/results/latest.json. What is measured how: docs/benchmarks.md.
import { writeFileSync } from 'node:fs';
import { cpus, loadavg } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { measureCancel, measureDrop, measureLongDrop, serveApp } from '../bench/app.mjs';
import { servePage } from '../bench/browser.mjs';
import { compareInApp, compareNatively } from '../bench/comparing.mjs';
import { benchmarkFiles } from '../bench/files.mjs';
import { measureFolder } from '../bench/folder.mjs';
import { measureLinkage, measureStages } from '../bench/linkage.mjs';
import {
  measureExtraction,
  measureLongestSteps,
  measureManyClips,
  measureOpening,
  measurePair,
  measureReading,
  measureStage,
} from '../bench/measure.mjs';
import { motionSet } from '../bench/motion-set.mjs';
import { timeNatively } from '../bench/native.mjs';
import { report } from '../bench/report.mjs';
import { root } from './process.mjs';

const parts = ['reading', 'extraction', 'opening', 'app', 'stage', 'folder', 'compare'];
const { values: options } = parseArgs({
  options: {
    short: { type: 'boolean', default: false },
    runs: { type: 'string', default: '7' },
    clips: { type: 'string', default: '3000' },
    vectors: { type: 'string', default: '10000' },
    only: { type: 'string', multiple: true, default: parts },
  },
});
const runs = Number(options.runs);
const frames = [4_500, 45_000, ...(options.short ? [] : [432_000])];
const results = join(root, 'bench', 'results');

/** Drops of the 3 MB file after the first, figures on the stage, clips of the folder. */
const DROPS = 10;
const FIGURES = [1, 20];
/** Clips on the stage of the page Pair. */
const TOGETHER = 20;
const CLIPS = 1_000;

/** Workers of the page, threads of the command. */
const WORKERS = [1, 2];

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

/** What each part measures, by its name. */
function measurements({ sets, long, samples }, native, page, app) {
  const [brief] = long;
  const hour = options.short ? [] : long.slice(-1);
  return {
    reading: () => inOrder(sets, (set) => measureReading(page, set, native, runsOf(set.paths[0]))),
    extraction: () => inOrder(long, (path) => measureExtraction(page, path, native, runsOf(path))),
    opening: () => inOrder(long, (path) => measureOpening(page, path, runsOf(path))),
    app: async () => ({
      drop: await measureDrop(app, brief, DROPS),
      long: await inOrder(hour, (path) => measureLongDrop(app, path)),
      cancel: await inOrder(hour, (path) => measureCancel(app, path, brief)),
    }),
    stage: async () => ({
      figures: await measureStage(page, brief, FIGURES),
      pair: await measurePair(page, samples.slice(0, TOGETHER)),
    }),
    folder: () => measureFolder(join(results, 'files', 'folder'), samples, CLIPS, 3),
    compare: () => measureComparing(page, app),
  };
}

/** A set compared by the command and in the app, and many vectors natively and in the page. */
async function measureComparing(page, app) {
  const set = motionSet(join(results, 'files'), Number(options.clips));
  const vectors = Number(options.vectors);
  return {
    set: {
      ...set,
      native: await inOrder(WORKERS, (count) => compareNatively(set, count)),
      app: await inOrder(WORKERS, (count) => compareInApp(app, set, count)),
    },
    linkage: measureLinkage(join(results, 'files'), vectors, Math.min(runs, 3)),
    stages: measureStages(vectors, Math.min(runs, 3)),
    many: await measureManyClips(page, vectors),
    steps: await measureLongestSteps(page, vectors),
  };
}

async function measureAll(files) {
  const all = [...new Set(files.sets.flatMap(({ paths }) => paths))];
  const isTimed = ['reading', 'extraction'].some((part) => options.only.includes(part));
  const native = isTimed ? timeNatively(all, runs) : new Map();
  const [page, app] = [await servePage(), await serveApp()];
  const measured = {};
  try {
    const by = measurements(files, native, page.address, app.address);
    for (const part of parts.filter((one) => options.only.includes(one))) {
      console.log(`measuring: ${part}`);
      measured[part] = await by[part]();
    }
  } finally {
    await page.close();
    await app.close();
  }
  return measured;
}

console.log('writing the files');
const files = benchmarkFiles(join(results, 'files'), frames);
const measured = { machine: machine(), runs, ...(await measureAll(files)) };
writeFileSync(join(results, 'latest.json'), `${JSON.stringify(measured, null, 2)}\n`);
console.log(`\n${report(measured)}\n`);
console.log(
  `${measured.machine.processors} × ${measured.machine.model}, load ${measured.machine.load.toFixed(1)} ` +
    `to ${loadavg()[0].toFixed(1)}; medians of up to ${runs} runs (minimum–maximum)`,
);
