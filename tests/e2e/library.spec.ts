/** The rows of the library: order, filter, and the keys that walk through them. */
import { sampleBytes, sampleFiles, temporaryFolder, writeFiles } from './support/motions';
import { expect, test } from './support/test';

test('sort by every measure, filter, and walk', async ({ app, page }) => {
  await app.openWith(...sampleFiles('walk-poser-30', 'slow-dance-hik-30', 'walk-hik-30'));
  const [poser, dance, hik] = ['walk-poser-30.bvh', 'slow-dance-hik-30.bvh', 'walk-hik-30.bvh'];
  const sort = async (name: string): Promise<void> => {
    await app.button('Sort').click();
    await page.getByRole('menuitemradio', { name, exact: true }).click();
  };
  await sort('Name');
  await app.expectNames(dance, hik, poser);
  await sort('Descending');
  await app.expectNames(poser, hik, dance);
  await sort('Keyposes');
  await app.expectNames(dance, poser, hik);
  await sort('Ascending');
  await app.expectNames(poser, hik, dance);
  await sort('Length');
  await app.expectNames(poser, hik, dance);
  await sort('Order of arrival');
  await app.expectNames(poser, dance, hik);

  await app.row(poser).getByRole('button').first().click();
  await page.keyboard.press('ArrowDown');
  await expect(app.openName).toHaveText(dance);
  await page.keyboard.press('ArrowDown');
  await expect(app.openName).toHaveText(hik);
  await expect(app.row(hik).getByRole('button').first()).toBeFocused();
  await page.keyboard.press('ArrowUp');
  await expect(app.openName).toHaveText(dance);
  await expect(page.locator('.clip-open[aria-current="true"]')).toHaveCount(1);

  const filter = app.field('Filter by name or label');
  await filter.fill('WALK 30');
  await app.expectNames(poser, hik);
  await expect(page.locator('.library-count')).toHaveText('2 of 3');
  await filter.fill('ｈｉｋ walk');
  await app.expectNames(hik);
  await filter.fill('waltz');
  await expect(page.locator('.library-nothing')).toHaveText('No clip’s name contains “waltz”.');
  await expect(app.openName).toHaveText(dance);
  await app.button('Clear the filter').click();
  await app.expectNames(poser, dance, hik);
});

test('keys walk on from a pressed row where a press moves no focus by itself', async ({
  app,
  page,
}) => {
  await page.addInitScript(() => addEventListener('mousedown', (event) => event.preventDefault()));
  await app.openWith(...sampleFiles('walk-poser-30', 'walk-hik-30'));
  await app.row('walk-poser-30.bvh').getByRole('button').first().click();
  await page.keyboard.press('ArrowDown');
  await expect(app.openName).toHaveText('walk-hik-30.bvh');
  // A menu gives the focus back to its button.
  await app.button('Sort').click();
  await page.keyboard.press('Escape');
  await expect(app.button('Sort')).toBeFocused();
});

test('what a filter finds is shown from its beginning', async ({ app, page }) => {
  const walk = sampleBytes('walk-hik-30');
  const names = ['open.bvh', ...Array.from({ length: 50 }, (_, n) => `walk${n}.bvh`)];
  const folder = temporaryFolder();
  writeFiles(folder, Object.fromEntries(names.map((name) => [name, walk])));
  await app.openWith(folder);
  await app.field('Filter by name or label').fill('open');
  await app.row('open.bvh').locator('.clip-open').click();
  await app.button('Clear the filter').click();
  const list = page.locator('.library-list');
  await list.evaluate((scroll) => scroll.scrollTo(0, 1200));
  await expect(app.row('walk30.bvh')).toBeVisible();
  await app.field('Filter by name or label').fill('walk');
  await expect(page.locator('.library-count')).toHaveText('50 of 51');
  await expect.poll(() => list.evaluate(({ scrollTop }) => scrollTop)).toBe(0);
});
