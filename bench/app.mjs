// The app itself, measured. In: files to drop on it. Out: times from the drop to keyposes and to the first
// frame handed to WebGL, the longest task of the page's thread, memory, and how soon a cancel is heard.
import { copyFileSync, existsSync, linkSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { build, preview } from 'vite';
import { chromiumArguments, findChromium, flatArguments } from '../scripts/chromium.mjs';
import { root } from '../scripts/process.mjs';
import { RendererMemory } from './memory.mjs';
import { spread } from './statistics.mjs';

const folder = join(root, 'bench', 'results', 'app');

/** Longer than any of it takes on a slow machine. */
const patienceMs = 120_000;

/** What comes after the keyposes, as thumbnail and timeline, and the collector, are done by then. */
const restMs = 1_500;

/** Builds and serves the app; `{ address, close }`. */
export async function serveApp() {
  const app = { configFile: join(root, 'vite.config.ts'), logLevel: 'error' };
  await build({ ...app, build: { outDir: folder, emptyOutDir: true } });
  const served = { build: { outDir: folder }, preview: { host: '127.0.0.1', port: 0 } };
  const server = await preview({ ...app, ...served });
  return { address: server.resolvedUrls.local[0], close: () => server.close() };
}

/** The same file under another name, which is another clip. */
export function namesake(path, number) {
  const other = path.replace(/\.bvh$/, `-${number}.bvh`);
  if (existsSync(other)) return other;
  try {
    linkSync(path, other);
  } catch {
    copyFileSync(path, other);
  }
  return other;
}

class App {
  constructor(page, session, memory) {
    Object.assign(this, { page, session, memory });
  }

  /** A real drop, as the browser hands it on. */
  async drop(...files) {
    const data = { items: [], files, dragOperationsMask: 1 };
    for (const type of ['dragEnter', 'dragOver', 'drop']) {
      await this.session.send('Input.dispatchDragEvent', { type, x: 300, y: 300, data });
    }
  }

  /** The longest task so far; those that come are counted anew. */
  takeLongestTask() {
    return this.page.evaluate(() => {
      const { longestTaskMs } = window.probe;
      window.probe.longestTaskMs = 0;
      return longestTaskMs;
    });
  }

  probe() {
    return this.page.evaluate(() => window.probe);
  }

  /** Waits until the page's function of the probe and of a value is true. */
  until(condition, value) {
    return this.page.waitForFunction(condition, value, { timeout: patienceMs, polling: 20 });
  }

  rest() {
    return this.page.waitForTimeout(restMs);
  }
}

/** Calls `use` with the app in a fresh browser. */
export async function inApp(address, search, use) {
  const browser = await chromium.launch({
    executablePath: findChromium(),
    // Nothing is drawn by WebGL: the page itself need not be rasterised by way of it either.
    args: search.includes('stage=off') ? flatArguments : chromiumArguments,
    timeout: 60_000,
  });
  try {
    const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
    await page.addInitScript({ path: join(root, 'bench', 'app-probe.js') });
    await page.goto(address + search, { waitUntil: 'networkidle' });
    await page.waitForTimeout(restMs);
    const session = await page.context().newCDPSession(page);
    return await use(new App(page, session, await RendererMemory.of(browser)));
  } finally {
    await browser.close();
  }
}

/** From the drop of a file to its keyposes and to its first frame, in ms. */
export function measureDrop(address, path, runs) {
  return inApp(address, '', async (app) => {
    const found = [];
    for (let run = 0; run <= runs; run += 1) {
      await app.drop(namesake(path, run));
      await app.until(() => window.probe.frameMs > 0);
      const { droppedMs, keyposesMs, frameMs } = await app.probe();
      found.push({ keyposesMs: keyposesMs - droppedMs, frameMs: frameMs - droppedMs });
      await app.rest();
    }
    const [first, ...later] = found;
    return {
      bytes: statSync(path).size,
      first,
      keyposes: spread(later.map(({ keyposesMs }) => keyposesMs)),
      frame: spread(later.map(({ frameMs }) => frameMs)),
    };
  });
}

/**
 * The same for a long clip, twice, with nothing drawn; the longest task before the first drop and from it on,
 * and memory for one clip.
 */
export function measureLongDrop(address, path) {
  return inApp(address, '?stage=off', async (app) => {
    const drops = [];
    const startTaskMs = await app.takeLongestTask();
    for (const number of [1, 2]) {
      await app.drop(namesake(path, number));
      await app.until(() => window.probe.keyposesMs > 0);
      await app.rest();
      const { droppedMs, keyposesMs, longestTaskMs } = await app.probe();
      const memoryBytes = app.memory.peakBytes();
      drops.push({ keyposesMs: keyposesMs - droppedMs, longestTaskMs, memoryBytes });
    }
    const [first, second] = drops;
    return {
      bytes: statSync(path).size,
      firstMs: first.keyposesMs,
      secondMs: second.keyposesMs,
      startTaskMs,
      longestTaskMs: second.longestTaskMs,
      memoryBytes: first.memoryBytes,
    };
  });
}

/**
 * A long file cancelled half-way, beside a short clip that stays: how long until no worker works on it,
 * how long until the short clip answers, and what memory is left of it.
 */
export function measureCancel(address, path, shortPath) {
  return inApp(address, '?stage=off', async (app) => {
    await app.drop(shortPath);
    await app.until(() => window.probe.keyposesMs > 0);
    await app.rest();
    await app.drop(namesake(path, 1));
    // Reading is the first half of the bar.
    await app.until(() => (document.querySelector('.clip progress')?.value ?? 0) >= 0.25);
    const held = app.memory.nowBytes();
    await app.until(() => document.querySelector('.progress-card button') !== null);
    await app.page.evaluate(() => {
      window.probe.cancelMs = performance.now();
      document.querySelector('.progress-card button').click();
    });
    await app.until(() => document.querySelector('.clip progress, .progress-card') === null);
    await app.rest();
    const { cancelMs, workerMs } = await app.probe();
    const clips = await app.page.locator('.clip').count();
    return {
      idleMs: Math.max(0, workerMs - cancelMs),
      clips,
      heldBytes: held,
      leftBytes: app.memory.nowBytes(),
    };
  });
}
