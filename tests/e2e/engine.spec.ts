/** The engine with real workers in a real browser: many files, cancel, archives, a worker that dies. */
import { expect, test } from '@playwright/test';
import { strToU8, zipSync } from 'fflate';
import { type EnginePage, serveEnginePage } from '../support/engine-page';

let served: EnginePage;

test.beforeAll(async () => {
  served = await serveEnginePage();
});

test.afterAll(() => served.close());

test('opens files side by side; a broken one harms no other', async ({ page }) => {
  await page.goto(`${served.address}?workers=2`);
  const outcomes = await page.evaluate(async () => {
    const { engine } = window;
    const [walk, dance] = [await engine.sample('walk'), await engine.sample('slow-dance')];
    const broken = { name: 'broken.bvh', folder: '', blob: new Blob(['HIERARCHY\nROOT a\n(\n']) };
    const opened = [walk, broken, dance, walk].map((source, id) => engine.open(id, source, {}, {}));
    const settled = await Promise.allSettled(opened);
    return settled.map((one) =>
      one.status === 'fulfilled'
        ? one.value.performers[0]?.keyposes?.keyposes.length
        : String(one.reason),
    );
  });
  expect(outcomes[0]).toBeGreaterThan(5);
  expect(outcomes[1]).toMatch(/broken\.bvh: expected-brace/);
  expect(outcomes[2]).toBeGreaterThan(5);
  expect(outcomes[3]).toBe(outcomes[0]);
});

test('cancels a long file half-way and goes on with the next', async ({ page }) => {
  await page.goto(`${served.address}?workers=1`);
  const outcome = await page.evaluate(async () => {
    const { engine } = window;
    const text = await (await engine.sample('walk')).blob.text();
    const start = text.indexOf('\n', text.indexOf('Frame Time')) + 1;
    const rows = new Blob([text.slice(start)]);
    const head = text.slice(0, start).replace(/Frames: .*/, 'Frames: 0');
    const repeats = Math.ceil(1e8 / rows.size);
    const blob = new Blob([head, ...Array.from({ length: repeats }, () => rows)]);
    const abort = new AbortController();
    let lastDone = 0;
    const onProgress = ({ done }: { done: number }) => {
      lastDone = done;
      if (done >= 0.2) abort.abort();
    };
    const source = { name: 'long.bvh', folder: '', blob };
    const work = { signal: abort.signal, onProgress };
    const error = await engine.open(1, source, {}, {}, work).catch((reason: Error) => reason.name);
    const next = await engine.open(2, await engine.sample('walk'), {}, {});
    return { error, lastDone, frames: next.frames };
  });
  expect(outcome.error).toBe('AbortError');
  expect(outcome.lastDone).toBeGreaterThanOrEqual(0.2);
  expect(outcome.lastDone).toBeLessThan(1);
  expect(outcome.frames).toBeGreaterThan(100);
});

test('unpacks an archive in a worker', async ({ page }) => {
  const archive = zipSync({
    'dances/踊り.bvh': strToU8('HIERARCHY'),
    'a.txt': strToU8(''),
    'last.bvh': strToU8('HIERARCHY'),
  });
  await page.route('**/archive.zip', (route) => route.fulfill({ body: Buffer.from(archive) }));
  await page.goto(served.address);
  const entries = await page.evaluate(async () => {
    const blob = await (await fetch('archive.zip')).blob();
    const found: string[] = [];
    await window.engine.unzip(blob, ({ folder, name, blob: { size } }) => {
      found.push(`${folder}|${name}|${size}`);
    });
    return found;
  });
  expect(entries).toEqual(['dances|踊り.bvh|9', '|last.bvh|9']);
});

test('names the file whose worker dies, and goes on with a new one', async ({ page }) => {
  await page.goto(`${served.address}?workers=1`);
  const samples = await page.evaluate(() => window.engine.samples());
  expect(samples).toHaveLength(4);
  await page.route('**/worker-*.js', (route) => route.abort());
  await page.reload();
  const open = (id: number) =>
    page.evaluate(
      (clip) =>
        window.engine
          .open(clip, { name: 'a.bvh', folder: '', blob: new Blob(['x']) }, {}, {})
          .then(() => 'opened')
          .catch(String),
      id,
    );
  expect(await open(1)).toContain('a.bvh: worker-died');
  await page.unroute('**/worker-*.js');
  expect(await open(2)).toContain('a.bvh: not-bvh');
});
