// What was measured, for reading. In: the data of measure.mjs. Out: tables as text.
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
    told(one.three),
    digits(one.times.ofMedians),
    digits(one.times.ofQuickest),
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

function bitsLine(reading) {
  const sum = (key) => reading.reduce((all, { bits }) => all + bits[key], 0);
  return `${sum('different')} of ${sum('values')} values differ from JavaScript's Number of their text.`;
}

/** The tables: medians, with minimum and maximum in brackets. */
export function report({ reading, extraction, opening }) {
  return [
    readingTable(reading),
    bitsLine(reading),
    extractionTable(extraction),
    openingTable(opening),
  ].join('\n\n');
}
