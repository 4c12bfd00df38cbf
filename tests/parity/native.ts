// What the command line says of motions. Out: the line of JSON of each, without the file's name, which is a
// path there; and the samples as it writes them.
import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import type { MotionFile } from './motions';

const root = join(import.meta.dirname, '..', '..');
const extension = process.platform === 'win32' ? '.exe' : '';

function commandPath(): string {
  const target = process.env['CARGO_TARGET_DIR'] ?? join(root, 'target');
  return join(target, 'release', `keypose${extension}`);
}

/** The report without the name of its file. */
export function withoutName(line: string): string {
  return line.trimEnd().replace(/^\{"file":"(?:[^"\\]|\\.)*",/, '{');
}

/** Writes all samples into a folder; none, saying so, where the command has not been built. */
export function writeSamples(folder: string): void {
  runCommand(['samples', folder]);
}

/** The line of JSON of each motion; null, saying so, where the command has not been built. */
export function nativeReports(motions: readonly Pick<MotionFile, 'path'>[]): string[] | null {
  const text = runCommand(['keyposes', '--json', ...motions.map(({ path }) => path)]);
  return text === null ? null : text.trimEnd().split('\n').map(withoutName);
}

/** What the command prints; null, saying so, where it has not been built. */
export function runCommand(args: readonly string[]): string | null {
  const command = commandPath();
  if (!existsSync(command)) {
    process.stderr.write(`skipped: no ${command} (cargo build --release -p keypose-cli)\n`);
    return null;
  }
  const result = spawnSync(command, args, { encoding: 'utf8', maxBuffer: 2 ** 28 });
  if (result.status !== 0) throw new Error(`${command} failed: ${result.stderr}`);
  return result.stdout;
}
