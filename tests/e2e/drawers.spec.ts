/** Side panels as drawers: the focus goes in, stays in and comes back. */
import type { Page } from '@playwright/test';
import { sampleFiles } from './support/motions';
import { expect, test } from './support/test';

const focusWithin = (page: Page, selector: string): Promise<boolean> =>
  page.evaluate((panel) => !!document.activeElement?.closest(panel), selector);

/** A whole round and a half, forward and back. */
async function expectFocusStays(page: Page, selector: string): Promise<void> {
  const stops = await page
    .locator(`${selector} :is(button, input, select, a, [tabindex])`)
    .filter({ visible: true })
    .count();
  for (const key of ['Tab', 'Shift+Tab'])
    for (let n = 0; n < stops * 1.5 + 2; n++) {
      await page.keyboard.press(key);
      expect(await focusWithin(page, selector)).toBe(true);
    }
}

test('1024 wide: the details are a drawer', async ({ app, page }) => {
  await page.setViewportSize({ width: 1024, height: 768 });
  await app.openWith(...sampleFiles('walk-hik-30'));
  const [library, details] = [page.locator('#library'), page.locator('#inspector')];
  await expect(library).toBeVisible();
  await expect(details).toBeHidden();
  const button = app.button('Details');
  await button.focus();
  await page.keyboard.press('Enter');
  await expect(details).toBeVisible();
  await expect(page.getByRole('dialog', { name: 'Details' })).toBeVisible();
  await expect.poll(() => focusWithin(page, '#inspector')).toBe(true);
  await expectFocusStays(page, '#inspector');
  await page.keyboard.press('Escape');
  await expect(details).toBeHidden();
  await expect(button).toBeFocused();

  await page.keyboard.press('Enter');
  await expect(details).toBeVisible();
  await page.locator('#scrim').click({ position: { x: 100, y: 300 } });
  await expect(details).toBeHidden();

  // A window that becomes wide puts the panel beside the study.
  await button.click();
  await page.setViewportSize({ width: 1440, height: 900 });
  await expect(page.locator('#scrim')).toBeHidden();
  await expect(details).not.toHaveAttribute('role', 'dialog');
  await app.button('Next keypose').click();
});

test('800 wide: the library is a drawer too', async ({ app, page }) => {
  await page.setViewportSize({ width: 800, height: 600 });
  await app.openWith(...sampleFiles('walk-hik-30', 'walk-poser-30'));
  const library = page.locator('#library');
  await expect(library).toBeHidden();
  const button = app.button('Library');
  await button.focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('.clip-open[aria-current="true"]')).toBeFocused();
  await expectFocusStays(page, '#library');
  await page.locator('.clip-open[aria-current="true"]').focus();
  await page.keyboard.press('ArrowDown');
  await expect(app.openName).toHaveText('walk-poser-30.bvh');
  await expect(library).toBeVisible();
  await page.keyboard.press('Enter');
  await expect(library).toBeHidden();
  await expect(button).toBeFocused();

  await page.keyboard.press('/');
  await expect(app.field('Filter by name or label')).toBeFocused();
  await page.keyboard.type('poser');
  await app.expectNames('walk-poser-30.bvh');
  await page.keyboard.press('Escape');
  await expect(app.field('Filter by name or label')).toHaveValue('');
  await expect(library).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(library).toBeHidden();
});

test('a clip chosen by the pointer leaves Space to playback', async ({ app, page }) => {
  await page.setViewportSize({ width: 800, height: 600 });
  await app.openWith(...sampleFiles('walk-hik-30', 'walk-poser-30'));
  await app.button('Library').click();
  await app.row('walk-poser-30.bvh').getByRole('button').first().click();
  await expect(page.locator('#library')).toBeHidden();
  await page.keyboard.press(' ');
  await expect(page.locator('#library')).toBeHidden();
  await expect(app.button('Pause')).toBeVisible();
});

test('a low window, as at 200 % zoom: everything is reached by scrolling', async ({
  app,
  page,
}) => {
  await page.setViewportSize({ width: 720, height: 450 });
  await app.openWith(...sampleFiles('walk-hik-30'));
  const study = page.locator('#study');
  const hidden = await study.evaluate((place) => place.scrollHeight - place.clientHeight);
  expect(hidden).toBeGreaterThan(0);
  await study.evaluate((place) => place.scrollTo(0, place.scrollHeight));
  await expect(app.button('Play')).toBeInViewport({ ratio: 1 });
  await expect(page.locator('.timeline-area > *').last()).toBeInViewport();
});

test('390 wide: language, theme and help are in a menu', async ({ app, page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await app.openWith(...sampleFiles('walk-hik-30'));
  await app.button('Language, theme, help').click();
  await page.getByRole('menuitem', { name: 'Keyboard shortcuts' }).click();
  await expect(page.getByRole('dialog', { name: 'Keyboard shortcuts' })).toBeVisible();
  await page.keyboard.press('Escape');
  await app.button('Language, theme, help').click();
  await page.getByRole('menuitem', { name: '日本語' }).click();
  await expect(page.locator('html')).toHaveAttribute('lang', 'ja');
});
