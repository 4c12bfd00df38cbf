// The keypose command that the project has built. Out: what it prints; null, saying so, where there is none.
import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';

const root = join(import.meta.dirname, '..', '..');
const extension = process.platform === 'win32' ? '.exe' : '';

/** Where it is, or would be. */
function commandPath(): string {
  const target = process.env['CARGO_TARGET_DIR'] ?? join(root, 'target');
  return join(target, 'debug', `keypose${extension}`);
}

export const isCommandBuilt = (): boolean => existsSync(commandPath());

/** What `keypose` with these arguments prints, working in `folder`; throws where it fails. */
export function runCommand(args: readonly string[], folder = root): string | null {
  const command = commandPath();
  if (!isCommandBuilt()) {
    process.stderr.write(`skipped: no ${command} (cargo build -p keypose-cli)\n`);
    return null;
  }
  const result = spawnSync(command, args, { cwd: folder, encoding: 'utf8', maxBuffer: 2 ** 28 });
  if (result.status !== 0) throw new Error(`${command} failed: ${result.stderr}`);
  return result.stdout;
}
