// `npm run sizes`: what a visitor downloads. In: dist/. Out: the size of the WebAssembly module and of all
// that the first screen asks for, as a browser loads it, raw and gzip; exit status 1 above the budgets.
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { withPage } from './page.mjs';
import { root } from './process.mjs';

const budgets_kb = { wasm: 300, firstScreen: 400 };

function measured(bytes) {
  return { raw: bytes.length, gzip: gzipSync(bytes).length };
}

/** The file names, relative to dist/, that a browser loads before the page is idle. */
function firstScreenFiles() {
  return withPage({}, async (page, address) => {
    const files = new Set();
    page.on('response', (response) => {
      const { protocol, pathname } = new URL(response.url());
      if (protocol === 'http:') files.add(pathname.slice(1) || 'index.html');
    });
    await page.goto(address, { waitUntil: 'networkidle' });
    return [...files].sort();
  });
}

function report(name, size) {
  const kb = (bytes) => `${(bytes / 1000).toFixed(1)} KB`.padStart(10);
  console.log(`${kb(size.raw)} raw ${kb(size.gzip)} gzip  ${name}`);
}

function total(sizes) {
  const sum = (key) => sizes.reduce((all, size) => all + size[key], 0);
  return { raw: sum('raw'), gzip: sum('gzip') };
}

const dist = join(root, 'dist');
const sizeOf = (file) => measured(readFileSync(join(dist, file)));
const files = await firstScreenFiles();
files.forEach((file) => report(file, sizeOf(file)));
const firstScreen = total(files.map(sizeOf));
report('FIRST SCREEN', firstScreen);
const wasmFiles = readdirSync(dist, { recursive: true }).filter((file) => file.endsWith('.wasm'));
const wasm = total(wasmFiles.map(sizeOf));
report('WASM', wasm);
if (wasm.gzip > budgets_kb.wasm * 1000 || firstScreen.gzip > budgets_kb.firstScreen * 1000) {
  console.error(
    `Above the budget: wasm ${budgets_kb.wasm} KB, first screen ${budgets_kb.firstScreen} KB, gzip.`,
  );
  process.exitCode = 1;
}
