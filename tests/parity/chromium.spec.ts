/** The WebAssembly module in Chromium says what the command line says, to the last bit. */
import { expect, test } from '@playwright/test';
import { testCore } from '../../web/src/engine/test-engine';
import { type EnginePage, serveEnginePage } from '../support/engine-page';
import { parityMotions } from './motions';
import { nativeReports, withoutName } from './native';

let served: EnginePage;

test.beforeAll(async () => {
  served = await serveEnginePage();
});

test.afterAll(() => served.close());

test('Chromium gives the reports of the command line', async ({ page }) => {
  test.setTimeout(180_000);
  const motions = parityMotions(await testCore());
  const native = nativeReports(motions);
  test.skip(native === null, 'the keypose command is not built');
  const paths = new Map(motions.map(({ name, path }) => [name, path]));
  await page.route('**/motions/*', (route) => {
    const name = decodeURIComponent(new URL(route.request().url()).pathname.split('/').pop() ?? '');
    return route.fulfill({ path: paths.get(name) ?? '' });
  });
  await page.goto(served.address);
  for (const [id, { name }] of motions.entries()) {
    const line = await page.evaluate(
      async ([clip, file]) => {
        const blob = await (await fetch(`motions/${encodeURIComponent(file)}`)).blob();
        await window.engine.open(clip, { name: file, folder: '', blob }, {}, {});
        const text = await window.engine.exportText(clip, 'keyposes-json');
        window.engine.close(clip);
        return text;
      },
      [id, name] as const,
    );
    expect(withoutName(line), name).toBe(native?.[id]);
  }
});
