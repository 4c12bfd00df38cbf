// Programs that a developer may have installed. In: names. Out: their paths; running ones, with what they need.
import { type ChildProcess, spawn } from 'node:child_process';
import { accessSync, constants, mkdtempSync, rmSync } from 'node:fs';
import { createServer } from 'node:net';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { delimiter, join } from 'node:path';

/** The first that can be run, of whole paths and of names on the PATH; null: none. */
export function findProgram(...names: readonly string[]): string | null {
  const folders = (process.env['PATH'] ?? '').split(delimiter).filter(Boolean);
  const paths = names.flatMap((name) =>
    name.includes('/') ? [name] : folders.map((folder) => join(folder, name)),
  );
  return paths.find(isProgram) ?? null;
}

function isProgram(path: string): boolean {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

export async function freePort(): Promise<number> {
  const server = createServer();
  await new Promise<void>((listening) => server.listen(0, '127.0.0.1', listening));
  const { port } = server.address() as AddressInfo;
  await new Promise((closed) => server.close(closed));
  return port;
}

/** An environment in which a browser leaves nothing behind, on a screen of its own where there is none. */
export class Place {
  readonly folder = mkdtempSync(join(tmpdir(), 'keypose-browser-'));
  readonly env: NodeJS.ProcessEnv = {
    ...process.env,
    HOME: this.folder,
    XDG_RUNTIME_DIR: this.folder,
    LIBGL_ALWAYS_SOFTWARE: '1',
  };
  private readonly running: ChildProcess[] = [];

  static async make(): Promise<Place> {
    const place = new Place();
    if (process.platform === 'linux') await place.addScreen();
    return place;
  }

  private async addScreen(): Promise<void> {
    const size = ['-screen', '0', '1600x1100x24'];
    const child = this.spawn('Xvfb', ['-displayfd', '1', ...size, '-nolisten', 'tcp']);
    const number = await toldBy(child, /^\d+(?=\n)/);
    Object.assign(this.env, { DISPLAY: `:${number}`, GDK_BACKEND: 'x11' });
    delete this.env['WAYLAND_DISPLAY'];
  }

  spawn(program: string, options: readonly string[]): ChildProcess {
    const child = spawn(program, options, { env: this.env, stdio: ['ignore', 'pipe', 'pipe'] });
    this.running.push(child);
    // Where a browser never came as far as to be closed.
    process.once('exit', () => child.kill());
    return child;
  }

  async leave(): Promise<void> {
    for (const child of this.running.reverse()) await stop(child);
    rmSync(this.folder, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
  }
}

async function stop(child: ChildProcess): Promise<void> {
  if (child.exitCode !== null || child.signalCode !== null) return;
  const ended = new Promise((resolve) => child.once('exit', resolve));
  child.kill();
  await ended;
}

/** What a program says first that fits; rejects with all it said where it ends before. */
export function toldBy(child: ChildProcess, pattern: RegExp): Promise<string> {
  return new Promise((resolve, reject) => {
    let said = '';
    const hear = (part: Buffer): void => {
      said += part.toString();
      const found = pattern.exec(said);
      if (found) resolve(found[0]);
    };
    child.stdout?.on('data', hear);
    child.stderr?.on('data', hear);
    child.once('error', reject);
    child.once('exit', () => reject(new Error(`${child.spawnfile} ended: ${said}`)));
  });
}
