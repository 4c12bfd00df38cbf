// The browser side. In: work for a page of Chromium. Out: what the page's `window.bench` answers. The page
// is built apart from the app and served for the time of the benchmark.
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { build, preview } from 'vite';
import { chromiumArguments, findChromium } from '../scripts/chromium.mjs';
import { root } from '../scripts/process.mjs';
import { RendererMemory } from './memory.mjs';

// Isolated pages have a clock of 5 µs instead of 100 µs.
const headers = {
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
};

const page = {
  configFile: false,
  logLevel: 'error',
  root: join(root, 'bench', 'page'),
  base: './',
  worker: { format: 'es' },
  build: {
    outDir: join(root, 'bench', 'results', 'page'),
    emptyOutDir: true,
    target: 'es2022',
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 2_000,
  },
};

/** Builds and serves the page; `{ address, close }`. */
export async function servePage() {
  await build(page);
  const server = await preview({ ...page, preview: { host: '127.0.0.1', port: 0, headers } });
  return { address: server.resolvedUrls.local[0], close: () => server.close() };
}

/**
 * Gives the files to a fresh page of a fresh browser, calls `window.bench[method](...args)` there, and
 * returns its answer with the memory that the page took: `{ value, memoryBytes, version }`.
 */
export async function inFreshPage(address, paths, method, ...args) {
  const browser = await chromium.launch({
    executablePath: findChromium(),
    args: chromiumArguments,
    timeout: 60_000,
  });
  try {
    const tab = await browser.newPage();
    const crash = new Promise((_, reject) =>
      tab.on('crash', () => reject(new Error('the page ran out of memory'))),
    );
    await tab.goto(address, { waitUntil: 'networkidle' });
    await tab.setInputFiles('#files', paths);
    const memory = await RendererMemory.of(browser);
    const call = ([name, values]) => window.bench[name](...values);
    const value = await Promise.race([tab.evaluate(call, [method, args]), crash]);
    return { value, memoryBytes: memory.peakBytes(), version: browser.version() };
  } finally {
    await browser.close();
  }
}
