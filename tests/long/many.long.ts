/** Three thousand clips at once: all are done, the same for any number of threads, and can be cancelled. */
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { type Page, expect, test } from '@playwright/test';
import { runCommand } from '../support/command';
import { type EnginePage, serveEnginePage } from '../support/engine-page';
import { giveFiles } from './given';
import { MANY, writeMany } from './many-files';

let served: EnginePage;
let folder: string;
let paths: string[];
let period: number;

test.beforeAll(async () => {
  served = await serveEnginePage();
  folder = mkdtempSync(join(tmpdir(), 'keypose-many-'));
  ({ paths, period } = writeMany(folder));
});

test.afterAll(async () => {
  rmSync(folder, { recursive: true });
  await served.close();
});

test('the command says the same for any number of threads', () => {
  const clips = join(folder, 'clips');
  const one = runCommand(['keyposes', '--json', '--threads', '1', clips]);
  expect(one?.trimEnd().split('\n')).toHaveLength(MANY);
  expect(runCommand(['keyposes', '--json', '--threads', '3', clips]) === one).toBe(true);
});

/** Opens all files, aborting after some were done; how each ended, and how long the end took to come. */
async function openAll(page: Page, abortAfter: number) {
  await page.goto(served.address);
  const input = await giveFiles(page, paths);
  return input.evaluate(async (element, after) => {
    const abort = new AbortController();
    const start = performance.now();
    let [done, abortedAt] = [0, 0];
    const opened = [...((element as HTMLInputElement).files ?? [])].map(async (blob, id) => {
      const source = { name: blob.name, folder: '', blob };
      const result = await window.engine.open(id, source, {}, {}, { signal: abort.signal });
      done += 1;
      if (done === after) {
        abortedAt = performance.now();
        abort.abort();
      }
      return result.performers[0]?.keyposes?.keyposes.length ?? 0;
    });
    const ended = await Promise.allSettled(opened);
    const end = performance.now();
    const keyposes = ended.map((one) => (one.status === 'fulfilled' ? one.value : -1));
    return { keyposes, allMs: end - start, cancelMs: end - abortedAt };
  }, abortAfter);
}

test('the engine opens all of them', async ({ page }) => {
  const { keyposes, allMs } = await openAll(page, Infinity);
  process.stdout.write(`${MANY} clips in ${(allMs / 1e3).toFixed(1)} s\n`);
  expect(Math.min(...keyposes)).toBeGreaterThan(5);
  expect(keyposes).toEqual(keyposes.map((_, index) => keyposes[index % period]));
});

test('a cancel ends all that wait', async ({ page }) => {
  const { keyposes, cancelMs } = await openAll(page, 100);
  process.stdout.write(`cancelled in ${cancelMs.toFixed(0)} ms\n`);
  expect(keyposes.filter((count) => count < 0).length).toBeGreaterThan(MANY / 2);
  expect(cancelMs).toBeLessThan(1_000);
});
