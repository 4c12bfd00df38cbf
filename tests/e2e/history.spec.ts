/** Back and forward of the browser lead through the pages that were seen, and not away from the clips. */
import { sampleFiles } from './support/motions';
import { expect, test } from './support/test';

test('back and forward lead through the pages', async ({ app, page }) => {
  await app.openWith(...sampleFiles('walk-hik-30', 'walk-poser-30'));
  const tab = page.locator('.page-tab');
  const expectPage = (name: string) =>
    expect(page.locator('.page-tab[aria-current="page"]')).toHaveText(name);
  await tab.nth(1).click();
  await expectPage('Compare');
  await tab.nth(2).click();
  await expectPage('Pair');
  await tab.nth(2).click();
  await page.goBack();
  await expectPage('Compare');
  await page.goBack();
  await expectPage('Study');
  await expect(app.rows).toHaveCount(2);
  await page.goForward();
  await expectPage('Compare');
  await page.reload();
  await expect(page.locator('.drop-zone')).toBeVisible();
  await app.drop(...sampleFiles('walk-hik-30'));
  await expectPage('Study');
});

test('the caption of the study is there for ears on its page only', async ({ app, page }) => {
  await app.openWith(...sampleFiles('walk-hik-30', 'walk-poser-30'));
  const spoken = page.locator('#spoken-caption');
  await expect(spoken).toContainText('Keypose 1');
  await page.locator('.page-tab').nth(1).click();
  await expect(spoken).toBeEmpty();
  await page.locator('.page-tab').nth(0).click();
  await expect(spoken).toContainText('Keypose 1');
});
