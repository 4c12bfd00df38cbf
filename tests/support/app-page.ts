// The app as it is shipped, built and served. Out: its address, and what ends the server.
import { mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { build } from 'vite';
import { type StaticServer, serveFolder } from './static-server';

const root = join(import.meta.dirname, '..', '..');

export async function serveApp(): Promise<StaticServer> {
  const outDir = mkdtempSync(join(tmpdir(), 'keypose-app-'));
  await build({ configFile: join(root, 'vite.config.ts'), logLevel: 'warn', build: { outDir } });
  return serveFolder(outDir, '/');
}
