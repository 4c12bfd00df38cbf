// The page with nothing but the engine, built and served. Out: its address, and what ends the server.
import { mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { build, preview } from 'vite';

export interface EnginePage {
  readonly address: string;
  close(): Promise<void>;
}

export async function serveEnginePage(): Promise<EnginePage> {
  const outDir = mkdtempSync(join(tmpdir(), 'keypose-engine-page-'));
  const shared = {
    configFile: false as const,
    logLevel: 'warn' as const,
    root: join(import.meta.dirname, 'engine-page'),
    build: { outDir, emptyOutDir: true, target: 'es2022', assetsInlineLimit: 0 },
  };
  await build({ ...shared, base: './', worker: { format: 'es' } });
  const server = await preview({ ...shared, preview: { host: '127.0.0.1', port: 0 } });
  const address = server.resolvedUrls?.local[0];
  if (address === undefined) throw new Error('the page of the engine is not served');
  return { address, close: () => server.close() };
}
