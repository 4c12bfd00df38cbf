// `npm run sizes`: what a visitor downloads. In: dist/. Out: the size of the WebAssembly modules, of all that
// the first screen asks for in each language, as a browser loads it, and of what the page fetches ahead for
// the study once it is idle, raw and gzip; exit status 1 above the budgets, or where the module of comparing,
// which only a set needs, comes before it is asked for.
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { withPage } from './page.mjs';
import { root } from './process.mjs';

const budgets_kb = { motion: 300, comparison: 150, firstScreen: 400 };

function measured(bytes) {
  return { raw: bytes.length, gzip: gzipSync(bytes).length };
}

/** The mark that web/src/shell/prefetch.ts sets before it fetches ahead. */
const prefetchMark = 'keypose.prefetch';

/** File names, relative to dist/: what a browser loads for the first screen, and what it then fetches ahead. */
function loadedFiles(locale) {
  return withPage({ locale }, async (page, address) => {
    const startedMs = new Map();
    page.on('request', (request) => {
      const { protocol, pathname } = new URL(request.url());
      const file = pathname.slice(1) || 'index.html';
      if (protocol === 'http:' && !startedMs.has(file)) startedMs.set(file, Date.now());
    });
    await page.goto(address, { waitUntil: 'networkidle' });
    // Polled from outside: the page's policy forbids what waitForFunction evaluates.
    const marked = () =>
      page.evaluate((mark) => {
        const entry = performance.getEntriesByName(mark)[0];
        return entry && performance.timeOrigin + entry.startTime;
      }, prefetchMark);
    while ((await marked()) === undefined) await page.waitForTimeout(100);
    await page.waitForLoadState('networkidle');
    const markMs = await marked();
    const files = [...startedMs.keys()].sort();
    const isAhead = (file) => startedMs.get(file) >= Math.floor(markMs);
    return {
      firstScreen: files.filter((file) => !isAhead(file)),
      ahead: files.filter(isAhead),
    };
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
const reported = (title, list) => {
  list.forEach((file) => report(file, sizeOf(file)));
  const size = total(list.map(sizeOf));
  report(title, size);
  return size;
};
const visits = [];
for (const locale of ['en-GB', 'ja-JP']) {
  const files = await loadedFiles(locale);
  const { gzip } = reported(`FIRST SCREEN, ${locale}`, files.firstScreen);
  reported('FETCHED AHEAD for the study', files.ahead);
  visits.push({ gzip, files: [...files.firstScreen, ...files.ahead] });
}
const wasmFiles = readdirSync(dist, { recursive: true }).filter((file) => file.endsWith('.wasm'));
const wasmOf = (module) => {
  const found = wasmFiles.filter((file) => file.includes(`${module}_wasm`));
  const size = total(found.map(sizeOf));
  report(`WASM of ${module}`, size);
  return size;
};
const sizes = {
  motion: wasmOf('motion').gzip,
  comparison: wasmOf('comparison').gzip,
  firstScreen: Math.max(...visits.map(({ gzip }) => gzip)),
};
const above = Object.keys(budgets_kb).filter((name) => sizes[name] > budgets_kb[name] * 1000);
for (const name of above) {
  console.error(`Above the budget of ${name}: ${budgets_kb[name]} KB gzip.`);
}
const early = visits
  .flatMap(({ files }) => files)
  .filter((file) => file.includes('comparison_wasm'));
if (early.length > 0) console.error(`Loaded before a set is there: ${early.join(', ')}.`);
if (above.length + early.length > 0) process.exitCode = 1;
