// The built app under a path of a server that knows nothing of it, as any web space. Out: its address.
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join } from 'node:path';

const dist = join(import.meta.dirname, '..', '..', '..', 'dist');

const types: Readonly<Record<string, string>> = {
  '.css': 'text/css',
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
};

export interface Served {
  readonly address: string;
  /** Paths asked for that are not there. */
  readonly missing: readonly string[];
  close(): void;
}

/** Serves dist/ under `path`, which begins and ends with a slash, and nothing else. */
export async function serveUnder(path: string): Promise<Served> {
  const missing: string[] = [];
  const server = createServer(({ url = '' }, response) => {
    const { pathname } = new URL(url, 'http://localhost');
    const name = pathname === path ? 'index.html' : pathname.slice(path.length);
    const found = pathname.startsWith(path)
      ? readFile(join(dist, name))
      : Promise.reject(new Error());
    found.then(
      (bytes) => response.writeHead(200, { 'Content-Type': types[extname(name)] }).end(bytes),
      () => {
        missing.push(pathname);
        response.writeHead(404).end();
      },
    );
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address() as AddressInfo;
  return {
    address: `http://127.0.0.1:${port}${path}`,
    missing,
    close: () => server.close(),
  };
}
