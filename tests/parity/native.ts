// What the command line says of motions. Out: the line of JSON of each, without the file's name, which is a
// path there; and the samples as it writes them.
import { runCommand } from '../support/command';
import type { MotionFile } from './motions';

/** The report without the name of its file. */
export function withoutName(line: string): string {
  return line.trimEnd().replace(/^\{"file":"(?:[^"\\]|\\.)*",/, '{');
}

/** Writes all samples into a folder; none, saying so, where the command has not been built. */
export function writeSamples(folder: string): void {
  runCommand(['samples', folder]);
}

/** The line of JSON of each motion; null, saying so, where the command has not been built. */
export function nativeReports(
  motions: readonly Pick<MotionFile, 'path'>[],
  ...options: string[]
): string[] | null {
  const paths = motions.map(({ path }) => path);
  const text = runCommand(['keyposes', '--json', ...options, ...paths]);
  return text === null ? null : text.trimEnd().split('\n').map(withoutName);
}
