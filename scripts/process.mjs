// Running other programs. In: a command and its arguments. Out: its text, its success, or an Error
// whose message says which command failed. Node built-ins only: used before `npm ci`.
import { spawnSync } from 'node:child_process';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';

/** The project's root folder. */
export const root = dirname(dirname(fileURLToPath(import.meta.url)));

// npm and the tools in node_modules/.bin are .cmd files on Windows, which only a shell starts.
const spawnOptions = { cwd: root, shell: process.platform === 'win32' };

/** Runs a command whose output goes to the terminal; throws where it fails. */
export function run(command, args, options = {}) {
  const result = spawnSync(command, args, { ...spawnOptions, stdio: 'inherit', ...options });
  if (result.error) throw new Error(`${command} could not be started: ${result.error.message}`);
  if (result.status !== 0) throw new Error(`"${command} ${args.join(' ')}" failed.`);
}

/** The trimmed standard output of a command, or null where it is missing or fails. */
export function output(command, args, options = {}) {
  const result = spawnSync(command, args, { ...spawnOptions, encoding: 'utf8', ...options });
  return result.status === 0 ? result.stdout.trim() : null;
}
