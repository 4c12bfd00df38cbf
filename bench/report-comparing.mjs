// What was measured of comparing, for reading. In: the data of comparing.mjs and linkage.mjs. Out: tables as text.
import { digits, table, told } from './statistics.mjs';

const megabytes = (bytes) => (bytes === null ? '–' : (bytes / 1e6).toFixed(0));
const seconds = (ms) => (ms / 1e3).toFixed(1);

function appTable({ clips, bytes, app }) {
  const header = [
    `${clips} clips dropped on the app (${megabytes(bytes)} MB)`,
    'first picture, s',
    'full comparison, s',
    'longest task, ms',
    'of the start, ms',
    'memory, MB',
  ];
  const rows = app.map((one) => [
    one.workers === 1 ? '1 worker' : `${one.workers} workers`,
    seconds(one.firstPictureMs),
    seconds(one.comparedMs),
    one.longestTaskMs.toFixed(0),
    one.startTaskMs.toFixed(0),
    megabytes(one.memoryBytes),
  ]);
  return table(header, rows);
}

function commandTable({ clips, native }) {
  const header = ['`keypose compare DIR --json`', 'threads', 's', 'memory, MB'];
  const rows = native.map((one) => [
    `${clips} clips`,
    one.threads,
    digits(one.seconds),
    megabytes(one.memoryBytes),
  ]);
  return table(header, rows);
}

function linkageTable(linkage) {
  const header = ['from vectors to the tree, ms', 'vectors', 'Keypose', 'kodama', 'SciPy'];
  const rows = linkage.map(({ method, count, keypose, kodama, scipy }) => [
    method === 'ward' ? 'Ward' : 'group average',
    count,
    told(keypose),
    told(kodama),
    told(scipy ?? null),
  ]);
  return table(header, rows);
}

/** How the stages are called in the table. */
const stageNames = {
  ward: 'Ward',
  order: 'order of the leaves',
  clusters: 'clusters by BIC',
  picture: 'picture of the matrix',
  map: 'map',
};

function stagesTable({ count, stages }) {
  const rows = Object.entries(stages).map(([name, ms]) => [stageNames[name], told(ms)]);
  return table([`${count} vectors`, 'native, ms'], rows);
}

function manyTable(many) {
  const header = [
    'in the page',
    'all known, s',
    'picture, ms',
    'a frame of JavaScript, ms: over the matrix',
    'over the map',
    'zooming',
  ];
  return table(header, [
    [
      `${many.clips} clips`,
      seconds(many.comparedMs),
      many.pictureMs.toFixed(0),
      told(many.hoverMatrixMs),
      told(many.hoverMapMs),
      told(many.zoomMatrixMs),
    ],
  ]);
}

function stepsTable(steps) {
  const [{ clips, longestMs }] = steps;
  const names = Object.keys(longestMs);
  const header = [`longest step of ${clips} clips, ms`, ...names, 'all compared, s', 'memory, MB'];
  const rows = steps.map((one) => [
    one.by,
    ...names.map((name) => digits(one.longestMs[name])),
    seconds(one.comparedMs),
    megabytes(one.memoryBytes),
  ]);
  return table(header, rows);
}

/** The tables of comparing. */
export function comparingTables({ set, linkage, stages, many, steps }) {
  return [
    appTable(set),
    commandTable(set),
    linkageTable(linkage),
    stagesTable(stages),
    manyTable(many),
    stepsTable(steps),
  ];
}
