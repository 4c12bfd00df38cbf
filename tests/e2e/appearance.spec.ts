/** Dark and light, wide and narrow. */
import type { Page } from '@playwright/test';
import type { AppPage } from './support/app-page';
import { sampleFiles } from './support/motions';
import { expect, test } from './support/test';

/** Mean of red, green and blue, 0 to 255, of a computed colour. */
async function lightness(page: Page, selector: string, property: string): Promise<number> {
  return page
    .locator(selector)
    .first()
    .evaluate((element, name) => {
      const context = document
        .createElement('canvas')
        .getContext('2d', { willReadFrequently: true })!;
      context.fillStyle = getComputedStyle(element).getPropertyValue(name);
      context.fillRect(0, 0, 1, 1);
      const [red = 0, green = 0, blue = 0] = context.getImageData(0, 0, 1, 1).data;
      return (red + green + blue) / 3;
    }, property);
}

async function expectTheme(page: Page, theme: 'light' | 'dark'): Promise<void> {
  await expect(page.locator('html')).toHaveAttribute('data-theme', theme);
  const ground = await lightness(page, 'html', 'background-color');
  const text = await lightness(page, 'html', 'color');
  if (theme === 'dark') {
    expect(ground).toBeLessThan(60);
    expect(text).toBeGreaterThan(180);
  } else {
    expect(ground).toBeGreaterThan(200);
    expect(text).toBeLessThan(80);
  }
}

test('the theme follows the system until it is chosen, and stays', async ({ app, page }) => {
  await page.emulateMedia({ colorScheme: 'dark' });
  await app.openWith(...sampleFiles('walk-hik-30'));
  await expectTheme(page, 'dark');
  await page.emulateMedia({ colorScheme: 'light' });
  await expectTheme(page, 'light');
  await app.button('Theme: as the system').click();
  await app.button('Theme: light').click();
  await expectTheme(page, 'dark');
  await page.reload();
  await expect(app.button('Theme: dark')).toBeVisible();
  await expectTheme(page, 'dark');
});

async function expectNoSidewaysScroll(app: AppPage): Promise<void> {
  const { scroll, client } = await app.page.evaluate(() => {
    const root = document.scrollingElement!;
    root.scrollLeft = 1000;
    return { scroll: root.scrollLeft, client: root.scrollWidth - root.clientWidth };
  });
  expect({ scroll, client }).toEqual({ scroll: 0, client: 0 });
}

for (const width of [320, 390, 768]) {
  test(`${width} pixels wide: nothing scrolls sideways, everything is reached`, async ({
    app,
    page,
  }) => {
    await page.setViewportSize({ width, height: 800 });
    await app.open();
    await expectNoSidewaysScroll(app);
    await app.drop(...sampleFiles('walk-hik-30'));
    await expect(app.caption).toContainText('of 10');
    await expectNoSidewaysScroll(app);
    await app.button('Library').click();
    await expect(app.row('walk-hik-30.bvh')).toBeInViewport();
    await expectNoSidewaysScroll(app);
    await page.keyboard.press('Escape');
    await app.button('Details').click();
    await expect(app.section('Result')).toBeInViewport();
    await expectNoSidewaysScroll(app);
    await page.keyboard.press('Escape');
    await app.button('Next keypose').click();
    await expect(app.button('Play')).toBeInViewport({ ratio: 1 });
  });
}
