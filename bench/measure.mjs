// The measurements. In: the page's address, sets of files, long clips, runs. Out: what was measured, as
// data that results are written and shown from.
import { statSync } from 'node:fs';
import { basename } from 'node:path';
import { inFreshPage } from './browser.mjs';
import { ratios, speeds, spread } from './statistics.mjs';

const names = (paths) => paths.map((path) => basename(path));
const bytesOf = (paths) => paths.reduce((sum, path) => sum + statSync(path).size, 0);

/** Milliseconds of each run over all paths together. */
function together(paths, native, key) {
  const series = paths.map((path) => native.get(path)[key]);
  return series[0].map((_, run) => series.reduce((sum, times) => sum + times[run], 0));
}

/** Reading one set: MB/s of each reader, and how many times faster than three.js. */
export async function measureReading(address, { title, paths }, native, runs) {
  const bytes = bytesOf(paths);
  const { value } = await inFreshPage(address, paths, 'read', names(paths), runs);
  const { value: bits } = await inFreshPage(address, paths, 'bits', names(paths));
  const speed = (times_ms) => spread(speeds(bytes, times_ms));
  return {
    title,
    bytes,
    keypose: speed(value.keypose),
    keyposeAndPoses: speed(value.keyposeAndPoses),
    three: speed(value.three),
    threeIsEnded: value.threeIsEnded,
    times: ratios(value.keypose, value.three),
    native: speed(together(paths, native, 'readMs')),
    bits,
  };
}

/** From the channels of one clip to its keyposes, in ms, and the longest step. */
export async function measureExtraction(address, path, native, runs) {
  const { value } = await inFreshPage(address, [path], 'extraction', basename(path), runs);
  const { frames, keyposes, analyseMs } = native.get(path);
  if (value.some((found) => found.keyposes !== keyposes || found.frames !== frames)) {
    throw new Error(`${path}: the browser and the native run find different keyposes`);
  }
  return {
    frames,
    keyposes,
    browser: spread(value.map((found) => found.analyseMs)),
    longestStep: spread(value.map((found) => found.longestStepMs)),
    native: spread(analyseMs),
  };
}

/** From a file on disk to keyposes and the first pose, through a worker, in ms; and the memory it took. */
export async function measureOpening(address, path, runs) {
  const once = await inFreshPage(address, [path], 'open', basename(path), 1);
  const many = await inFreshPage(address, [path], 'open', basename(path), runs + 1);
  const [first, ...later] = many.value.openedMs;
  return {
    file: basename(path),
    bytes: bytesOf([path]),
    first,
    later: spread(later),
    longestTask: many.value.longestTaskMs,
    memoryBytes: once.memoryBytes,
    chromium: many.version,
  };
}

/** The JavaScript of one frame of the stage, in ms, and what it draws, by number of figures. */
export async function measureStage(address, path, counts) {
  const { value } = await inFreshPage(address, [path], 'drawFrames', basename(path), counts);
  return value.map(({ frameMs, ...drawn }) => ({ ...drawn, frame: spread(frameMs) }));
}

/** The JavaScript of one frame of the page Pair, in ms, with all these clips on its stage, and its draw calls. */
export async function measurePair(address, paths) {
  const { value } = await inFreshPage(address, paths, 'pairFrames', names(paths));
  const { frameMs, ...drawn } = value;
  return { ...drawn, frame: spread(frameMs) };
}

/** So many vectors compared in the page: until all is known, until the matrix is drawn, and frames, in ms. */
export async function measureManyClips(address, count) {
  const { value } = await inFreshPage(address, [], 'manyClips', count);
  const { hoverMatrixMs, hoverMapMs, zoomMatrixMs, ...times } = value;
  const frames = { hoverMatrixMs, hoverMapMs, zoomMatrixMs };
  const spreads = Object.entries(frames).map(([name, each]) => [name, spread(each)]);
  return { ...times, ...Object.fromEntries(spreads) };
}

/** What so many vectors are compared by in `measureLongestSteps`. */
const STEPS_BY = ['Ward', 'group average', 'mirror-aware'];

/** The longest steps of what the comparison's worker does with so many vectors, in ms, and its memory. */
export async function measureLongestSteps(address, count) {
  const found = [];
  for (const by of STEPS_BY) {
    const { value } = await inFreshPage(address, [], 'longestSteps', count, by);
    found.push({ by, ...value });
  }
  return found;
}
