/** An hour of motion at 120 frames per second: the same everywhere, in bounded memory, without a long task. */
import { mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test } from '@playwright/test';
import { writeLongClip } from '../../bench/long-clip.mjs';
import { RendererMemory } from '../../bench/memory.mjs';
import { slicesOf } from '../../web/src/engine/slices';
import { testCore } from '../../web/src/engine/test-engine';
import { nativeReports, withoutName, writeSamples } from '../parity/native';
import { type EnginePage, serveEnginePage } from '../support/engine-page';
import { giveFiles } from './given';

const FRAMES = 432_000;

let served: EnginePage;
let folder: string;
let path: string;
let native: string;

test.beforeAll(async () => {
  served = await serveEnginePage();
  folder = mkdtempSync(join(tmpdir(), 'keypose-hour-'));
  writeSamples(folder);
  path = join(folder, 'hour.bvh');
  writeLongClip(path, readFileSync(join(folder, 'slow-dance-hik-120.bvh'), 'utf8'), FRAMES);
  native = nativeReports([{ path }])?.[0] ?? '';
});

test.afterAll(async () => {
  rmSync(folder, { recursive: true });
  await served.close();
});

test('Node gives the report of the command line', async () => {
  const bytes = readFileSync(path);
  const clip = (await testCore()).newClip();
  clip.beginReading(bytes.length);
  for await (const slice of slicesOf(new Blob([bytes]))) clip.push(slice);
  clip.endReading();
  clip.beginAnalysis({}, {});
  while (clip.step() < 1);
  const { sha256 } = JSON.parse(native) as { sha256: string };
  expect(withoutName(clip.report('keyposes-json', 'hour.bvh', sha256))).toBe(native);
  clip.free();
});

test('Chromium gives it too, within four times the file in memory', async ({ page, browser }) => {
  await page.goto(served.address);
  const input = await giveFiles(page, [path]);
  const memory = await RendererMemory.of(browser);
  const found = await input.evaluate(async (element) => {
    const [blob = new File([], '')] = (element as HTMLInputElement).files ?? [];
    // The work of this test itself is not to be measured.
    await new Promise((resolve) => setTimeout(resolve, 200));
    const longTasks: number[] = [];
    const observer = new PerformanceObserver((list) => {
      for (const { duration } of list.getEntries()) longTasks.push(duration);
    });
    observer.observe({ type: 'longtask' });
    const start = performance.now();
    await window.engine.open(1, { name: 'hour.bvh', folder: '', blob }, {}, {});
    const openedMs = performance.now() - start;
    observer.disconnect();
    return { openedMs, longTasks };
  });
  const peak = memory.peakBytes();
  const text = await page.evaluate(() => window.engine.exportText(1, 'keyposes-json'));
  const times = (peak ?? 0) / statSync(path).size;
  process.stdout.write(
    `opened in ${found.openedMs.toFixed(0)} ms, memory ${times.toFixed(1)} × file\n`,
  );
  expect(withoutName(text)).toBe(native);
  expect(found.longTasks).toEqual([]);
  expect(times).toBeLessThan(4);
});
