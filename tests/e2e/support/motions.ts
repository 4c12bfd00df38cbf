// Files to drop on the page, in a folder of the test's own: samples of the generator, small broken ones,
// long ones. Out: their paths.
import { mkdirSync, mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { runCommand } from '../../support/command';

/** Two gaits in two rigs each, and two dances: a set to compare. */
export const sixSamples = [
  'walk-hik-30',
  'walk-poser-30',
  'run-hik-30',
  'run-poser-30',
  'slow-dance-hik-30',
  'tired-dance-hik-30',
];

export function temporaryFolder(): string {
  return mkdtempSync(join(tmpdir(), 'keypose-e2e-'));
}

/** The bytes of a sample by its whole name, as `walk-hik-30`. */
export function sampleBytes(id: string): Uint8Array {
  const folder = temporaryFolder();
  runCommand(['samples', folder, id]);
  return readFileSync(join(folder, `${id}.bvh`));
}

export function sampleText(id: string): string {
  return new TextDecoder().decode(sampleBytes(id));
}

/** Writes files, by path within the folder, and returns their whole paths. */
export function writeFiles(folder: string, files: Record<string, string | Uint8Array>): string[] {
  return Object.entries(files).map(([name, content]) => {
    const path = join(folder, name);
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, content);
    return path;
  });
}

/** Samples as files `ID.bvh` of a new folder. */
export function sampleFiles(...ids: string[]): string[] {
  const files = Object.fromEntries(ids.map((id) => [`${id}.bvh`, sampleBytes(id)]));
  return writeFiles(temporaryFolder(), files);
}

/** Where the rows of numbers begin. */
const rowsAt = (text: string): number => text.indexOf('\n', text.indexOf('Frame Time')) + 1;

/** A sample whose rows are repeated until it is as long as asked for. */
export function longText(id: string, bytes: number): string {
  const text = sampleText(id);
  const rows = text.slice(rowsAt(text));
  const repeats = Math.ceil(bytes / rows.length);
  const frames = repeats * rows.trimEnd().split('\n').length;
  return (
    text.slice(0, rowsAt(text)).replace(/Frames:.*/, `Frames: ${frames}`) + rows.repeat(repeats)
  );
}

/** A sample with one value too few in a row; `line` is where, from 1. */
export function withShortRow(id: string): { text: string; line: number } {
  const lines = sampleText(id).split('\n');
  const index = lines.findIndex((line) => line.startsWith('Frame Time')) + 5;
  lines[index] = (lines[index] ?? '').split(/\s+/).slice(1).join(' ');
  return { text: lines.join('\n'), line: index + 1 };
}

/** A sample after one frame in which every value is zero: its rest pose. */
export function withRestPose(id: string): string {
  const text = sampleText(id);
  const at = rowsAt(text);
  const width = text.slice(at).split('\n')[0]?.trim().split(/\s+/).length ?? 0;
  const more = text
    .slice(0, at)
    .replace(/Frames:\s*(\d+)/, (_, count: string) => `Frames: ${Number(count) + 1}`);
  return `${more}${Array(width).fill('0').join(' ')}\n${text.slice(at)}`;
}

/** A sample's body and motion twice, the second beside the first. */
export function withTwoPerformers(id: string): string {
  const [head = '', motion = ''] = sampleText(id).split(/^MOTION\s*$/m);
  const body = head.slice(head.indexOf('ROOT'));
  const [frames = '', time = '', ...rows] = motion.trim().split('\n');
  const beside = (row: string): string => {
    const [x = '0', ...rest] = row.trim().split(/\s+/);
    return [Number(x) + 120, ...rest].join(' ');
  };
  const both = rows.map((row) => `${row.trim()} ${beside(row)}`);
  return ['HIERARCHY', body + body + 'MOTION', frames, time, ...both, ''].join('\n');
}

/** A few frames of one joint and its end: read in no time, and not human. */
export function tinyBvh(frames: number): string {
  const rows = Array.from(
    { length: frames },
    (_, n) => `0 ${Math.sin(n / 5).toFixed(4)} 0 0 ${n} 0`,
  );
  const channels = 'CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation';
  return [
    'HIERARCHY',
    `ROOT Hips\n{\n OFFSET 0 0 0\n ${channels}\n End Site\n {\n  OFFSET 0 10 0\n }\n}`,
    `MOTION\nFrames: ${frames}\nFrame Time: 0.0333333\n${rows.join('\n')}\n`,
  ].join('\n');
}
