// What was measured, for reading. In: the data of measure.mjs. Out: tables as text.
import { comparingTables } from './report-comparing.mjs';
import { digits, table, told } from './statistics.mjs';

const megabytes = (bytes) => (bytes / 1e6).toFixed(1);

function readingTable(reading) {
  const header = [
    'reading, MB/s',
    'MB',
    'Keypose',
    '… and poses',
    'three.js',
    'times',
    'quickest',
    'native',
  ];
  const rows = reading.map((one) => [
    one.title,
    megabytes(one.bytes),
    told(one.keypose),
    told(one.keyposeAndPoses),
    (one.threeIsEnded ? '< ' : '') + told(one.three),
    (one.threeIsEnded ? '≥ ' : '') + digits(one.times.ofMedians),
    (one.threeIsEnded ? '≥ ' : '') + digits(one.times.ofQuickest),
    told(one.native),
  ]);
  return table(header, rows);
}

function extractionTable(extraction) {
  const header = ['extraction, ms', 'keyposes', 'browser', 'longest step', 'native'];
  const rows = extraction.map((one) => [
    `${one.frames} frames`,
    one.keyposes,
    told(one.browser),
    told(one.longestStep),
    told(one.native),
  ]);
  return table(header, rows);
}

function openingTable(opening) {
  const header = ['opening, ms', 'MB', 'first', 'later', 'longest task', 'memory, MB', '× file'];
  const rows = opening.map((one) => [
    one.file,
    megabytes(one.bytes),
    one.first.toFixed(0),
    told(one.later),
    one.longestTask.toFixed(0),
    one.memoryBytes === null ? '–' : megabytes(one.memoryBytes),
    one.memoryBytes === null ? '–' : (one.memoryBytes / one.bytes).toFixed(1),
  ]);
  return table(header, rows);
}

const times = (bytes, of) => (bytes === null ? '–' : (bytes / of).toFixed(1));
const milliseconds = (ms) => ms.toFixed(0);

function dropTable({ drop, long }) {
  const header = ['dropped on the app, ms', 'MB', 'first', 'later', 'longest task', '× file'];
  const rows = [
    [
      'keyposes known',
      megabytes(drop.bytes),
      milliseconds(drop.first.keyposesMs),
      told(drop.keyposes),
    ],
    [
      'first frame to WebGL',
      megabytes(drop.bytes),
      milliseconds(drop.first.frameMs),
      told(drop.frame),
    ],
    ...long.map((one) => [
      'an hour, keyposes known',
      megabytes(one.bytes),
      milliseconds(one.firstMs),
      milliseconds(one.secondMs),
      milliseconds(one.longestTaskMs),
      times(one.memoryBytes, one.bytes),
    ]),
  ];
  const empty = header.map(() => '');
  return table(
    header,
    rows.map((row) => [...row, ...empty.slice(row.length)]),
  );
}

function startLine({ startTaskMs }) {
  return `longest task before the first drop, of the page's own start: ${milliseconds(startTaskMs)} ms.`;
}

function cancelLine({ idleMs, clips, heldBytes, leftBytes }) {
  const memory =
    heldBytes === null
      ? ''
      : `; memory ${megabytes(heldBytes)} MB before, ${megabytes(leftBytes)} MB after`;
  return `cancelled half-way: idle after ${milliseconds(idleMs)} ms, clips left: ${clips}${memory}.`;
}

function stageTable({ figures, pair }) {
  const header = [
    'stage, one frame',
    'JavaScript, ms',
    'draw calls',
    'triangles',
    'uniform vectors',
  ];
  const rows = figures.map((one) => [
    one.figures === 1 ? '1 figure' : `${one.figures} figures`,
    told(one.frame),
    one.drawCalls,
    one.triangles,
    one.uniformVectors,
  ]);
  const together = [`page Pair, ${pair.clips} clips`, told(pair.frame), pair.drawCalls, '', ''];
  return table(header, [...rows, together]);
}

function folderTable(folder) {
  const header = ['`keypose keyposes DIR`', 'MB', 'MB/s a core', 'clips/s a core'];
  const { clips, bytes, megabytesPerSecond, clipsPerSecond } = folder;
  return table(header, [
    [`${clips} clips`, megabytes(bytes), told(megabytesPerSecond), told(clipsPerSecond)],
  ]);
}

function bitsLine(reading) {
  const sum = (key) => reading.reduce((all, { bits }) => all + bits[key], 0);
  return `${sum('different')} of ${sum('values')} values differ from JavaScript's Number of their text.`;
}

/** The tables of what was measured: medians, with minimum and maximum in brackets. */
export function report({ reading, extraction, opening, app, stage, folder, compare }) {
  return [
    ...(reading ? [readingTable(reading), bitsLine(reading)] : []),
    ...(extraction ? [extractionTable(extraction)] : []),
    ...(opening ? [openingTable(opening)] : []),
    ...(app ? [dropTable(app), ...app.long.map(startLine), ...app.cancel.map(cancelLine)] : []),
    ...(stage ? [stageTable(stage)] : []),
    ...(folder ? [folderTable(folder)] : []),
    ...(compare ? comparingTables(compare) : []),
  ].join('\n\n');
}
