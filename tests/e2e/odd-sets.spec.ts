/** Sets that nobody wishes for: all the same, names of every kind, one of a kind, tiny windows. */
import type { Page } from '@playwright/test';
import type { AppPage } from './support/app-page';
import { sampleBytes, temporaryFolder, tinyBvh, writeFiles } from './support/motions';
import { expect, test } from './support/test';

const options = (page: Page) => page.locator('.matrix-name');
const cut = (page: Page) => page.getByRole('slider', { name: 'Cut of the tree' });
const pattern = (page: Page) => page.getByLabel('Pattern', { exact: true });

async function compare(
  app: AppPage,
  page: Page,
  files: Record<string, string | Uint8Array>,
): Promise<void> {
  const folder = temporaryFolder();
  writeFiles(folder, files);
  const tops = [...new Set(Object.keys(files).map((name) => name.split('/')[0] ?? ''))];
  await app.openWith(...tops.map((top) => `${folder}/${top}`));
  await page.locator('.page-tab', { hasText: 'Compare' }).click();
}

test('ten times the same motion: every distance is 0, and nothing is made of it', async ({
  app,
  page,
}) => {
  const walk = sampleBytes('walk-hik-30');
  const files = Array.from({ length: 10 }, (_, n) => [`${'ab'[n % 2]}_${n}.bvh`, walk] as const);
  await compare(app, page, Object.fromEntries(files));
  await expect(options(page)).toHaveCount(10);
  await expect(cut(page)).toHaveAttribute('aria-valuemax', '10');
  await options(page).nth(0).click();
  await options(page)
    .nth(9)
    .click({ modifiers: ['Shift'] });
  await expect(page.locator('.distance-sentence')).toContainText('The same.');
  await cut(page).focus();
  for (const [key, clusters] of [
    ['End', 10],
    ['Home', 1],
    ['PageUp', 6],
  ] as const) {
    await page.keyboard.press(key);
    await expect(cut(page)).toHaveAttribute('aria-valuenow', String(clusters));
  }
  await page.getByRole('button', { name: 'Labels from file names…' }).click();
  await pattern(page).fill('{label}_*');
  await pattern(page).press('Enter');
  // Of equals the first counts, as the command line says.
  await expect(page.getByRole('region', { name: 'Against labels' })).toContainText('4 of 10');
  await page.getByRole('tab', { name: 'Table' }).click();
  const table = await page.getByRole('grid', { name: 'All clips' }).innerText();
  expect(table).not.toMatch(/NaN|undefined|∞/);
  await page.getByRole('button', { name: 'Open pair' }).click();
  await expect(page.locator('.pair-distance > b')).toHaveText(/^0(\.0+)?$/);
  await expect(page.locator('.pair-difference')).toBeVisible();
  await page.keyboard.press('End');
});

const long = 'n'.repeat(200);
const markup = '<img src=x onerror=alert(1)>_1';

test('names are text: markup, emoji, two hundred signs; namesakes are told apart', async ({
  app,
  page,
}) => {
  test.setTimeout(120_000);
  const [walk, run] = [sampleBytes('walk-hik-30'), sampleBytes('run-hik-30')];
  page.on('dialog', () => expect('a name').toBe('never run'));
  await compare(app, page, {
    [`${markup}.bvh`]: walk,
    '💃🏽_"two" & {label}.bvh': run,
    [`${long}_3.bvh`]: sampleBytes('slow-dance-hik-30'),
    'set/first/walk.bvh': sampleBytes('walk-poser-30'),
    'set/second/walk.bvh': sampleBytes('run-poser-30'),
  });
  await expect(options(page)).toHaveCount(5);
  const titles = await options(page).evaluateAll((all) =>
    all.map((one) => one.getAttribute('title')),
  );
  expect(titles).toContain(markup);
  expect(titles).toContain(`${long}_3`);
  expect(titles).toContain('set/first walk');
  expect(titles).toContain('set/second walk');
  await page.locator('.matrix-name[title="set/first walk"]').click();
  const why = page.getByRole('tabpanel');
  await expect(why.locator('.nearest h3')).toHaveText('Nearest to set/first walk');
  await expect(why.locator('.near-card[title="set/second walk"]')).toBeVisible();
  await expect(page.locator('img')).toHaveCount(0);
  const wide = (): Promise<number> =>
    page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  expect(await wide()).toBeLessThanOrEqual(0);
  // A label of one clip, and a name that holds the very sign of the pattern.
  await page.getByRole('button', { name: 'Labels from file names…' }).click();
  for (const [text, fault] of [
    ['', 'Write {label} where the label stands.'],
    ['*{label}*', 'Something must stand between'],
    ['{label}{label}', '{label} can stand only once.'],
    ['{lable}', 'Braces can only stand around'],
  ] as const) {
    await pattern(page).fill(text);
    await pattern(page).press('Enter');
    await expect(page.locator('.label-fault')).toContainText(fault);
  }
  await pattern(page).fill('{label}_1');
  await pattern(page).press('Enter');
  await expect(page.locator('.evaluation')).toContainText('4 clips have no label');
  await expect(page.locator('.evaluation')).toContainText(markup.replace('_1', ''));
  await page.getByRole('tab', { name: 'Table' }).click();
  for (const width of [320, 1440]) {
    await page.setViewportSize({ width, height: 900 });
    await expect.poll(wide).toBeLessThanOrEqual(0);
  }
  await page.locator('.page-tab', { hasText: 'Pair' }).click();
  await page.setViewportSize({ width: 320, height: 700 });
  await expect.poll(wide).toBeLessThanOrEqual(0);
  await page.setViewportSize({ width: 1440, height: 900 });
  await page.locator('.page-tab', { hasText: 'Compare' }).click();
  await expect(options(page)).toHaveCount(5);
});

test('one human among props waits for another; two are enough; all can go, and come back', async ({
  app,
  page,
}) => {
  const props = Array.from({ length: 30 }, (_, n) => [`prop-${n}.bvh`, tinyBvh(20 + n)] as const);
  await compare(app, page, {
    'walk.bvh': sampleBytes('walk-hik-30'),
    ...Object.fromEntries(props),
  });
  await expect(page.getByRole('button', { name: '30 clips stand apart' })).toBeVisible();
  await expect(page.locator('.compare-message')).toContainText('drop another');
  await app.drop(...writeFiles(temporaryFolder(), { 'run.bvh': sampleBytes('run-hik-30') }));
  await expect(options(page)).toHaveCount(2);
  await expect(cut(page)).toHaveAttribute('aria-valuemax', '2');
  await page.getByRole('gridcell').focus();
  await page.keyboard.press('Control+Home');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press(' ');
  await expect(page.locator('.pair-name')).toHaveCount(2);
  // A language, a theme and another distance on the way.
  await page.getByRole('button', { name: '日本語' }).click();
  await expect(page.locator('html')).toHaveAttribute('lang', 'ja');
  await expect(page.getByRole('grid', { name: '距離行列' })).toBeVisible();
  await page.getByRole('button', { name: 'English' }).click();
  for (let n = 0; n < 4; n++) {
    await page.getByRole('button', { name: /^Distance/ }).click();
    await page
      .getByRole('menuitemcheckbox')
      .nth(n % 2)
      .click();
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: /^Theme/ }).click();
  }
  await expect(page.getByRole('button', { name: /^Distance/ })).toHaveText('Posture variation');
  await expect(page.locator('#compare')).not.toHaveClass(/comparing/);
  for (const name of ['run.bvh', 'walk.bvh']) {
    await app.field('Filter by name or label').fill(name);
    await app.row(name).locator('.clip-open').press('Delete');
    await expect(app.rows).toHaveCount(0);
  }
  await expect(page.locator('.compare-message')).toContainText('drop another');
  await app.button('Clear the filter').first().click();
  await page.getByRole('tab', { name: 'Why' }).focus();
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await expect(options(page)).toHaveCount(2);
});
