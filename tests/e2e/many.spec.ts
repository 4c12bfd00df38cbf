// Many files at once: all can be compared soon, the page answers meanwhile, a cancel keeps what is read.
import { join } from 'node:path';
import { sampleBytes, temporaryFolder, writeFiles } from './support/motions';
import { stageOff } from './support/app-page';
import { expect, test } from './support/test';

function filledFolder(count: number): string {
  const folder = temporaryFolder();
  const walk = sampleBytes('walk-hik-30');
  const names = Array.from({ length: count }, (_, n) => `set/m${n}.bvh`);
  writeFiles(folder, {
    ...Object.fromEntries(names.map((name) => [name, walk])),
    'set/broken.bvh': 'no motion',
  });
  return join(folder, 'set');
}

const isCompared = (count: number): boolean =>
  performance
    .getEntriesByName('comparison-full')
    .some((mark) => (mark as PerformanceMark).detail === count);

test('two hundred clips: all are compared, then their keyposes follow', async ({ app, page }) => {
  await app.open();
  await app.drop(filledFolder(200));
  await expect(page.locator('.library-count')).toHaveText('201 clips');
  await page.waitForFunction(isCompared, 200);
  await expect(app.toast).toContainText('broken.bvh');
  await expect(page.locator('.progress-card')).toHaveCount(0, { timeout: 60_000 });
  await app.field('Filter by name or label').fill('m199');
  await expect(page.locator('.clip .count')).toHaveCount(1);
});

test('a clip opened before its turn has its keyposes; a cancel keeps the rest', async ({
  app,
  page,
}) => {
  await app.open(`${stageOff}&workers=1`);
  await app.drop(filledFolder(500));
  await page.waitForFunction(isCompared, 500);
  await app.button('Cancel reading').click();
  await expect(page.locator('.progress-card')).toHaveCount(0);
  await expect(page.locator('.library-count')).toHaveText('501 clips');
  await app.field('Filter by name or label').fill('m499');
  await app.row('m499.bvh').getByRole('button').first().click();
  await expect(app.section('Result')).toContainText('keyposes');
});
