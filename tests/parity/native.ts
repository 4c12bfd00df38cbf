// What the command line says of motions. Out: the line of JSON of each, without the file's name, which is a
// path there; null, saying so, where the command has not been built.
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

export function nativeReports(motions: readonly MotionFile[]): string[] | null {
  const command = commandPath();
  if (!existsSync(command)) {
    process.stderr.write(`skipped: no ${command} (cargo build --release -p keypose-cli)\n`);
    return null;
  }
  const paths = motions.map(({ path }) => path);
  const result = spawnSync(command, ['keyposes', '--json', ...paths], {
    encoding: 'utf8',
    maxBuffer: 2 ** 28,
  });
  if (result.status !== 0) throw new Error(`${command} failed: ${result.stderr}`);
  return result.stdout.trimEnd().split('\n').map(withoutName);
}
