/** The empty page: there before the WebAssembly, its pictures are those of the real analysis, at every width. */
import type { Page } from '@playwright/test';
import { sampleFiles } from './support/motions';
import { reportOf } from './support/reports';
import { expect, test } from './support/test';

/** The samples offered, in their order, as the command line names them. */
const offered = ['slow-dance-hik-60', 'tired-dance-vrm-30', 'walk-poser-120', 'run-hik-120'];

const pictures = (page: Page) => page.locator('.sample-figures:has(.figure)');

/** Left and right edges of the hero's figures, from left to right. */
function figureEdges(page: Page): Promise<{ left: number; right: number }[]> {
  return page.evaluate(() =>
    [...document.querySelectorAll('.hero .figure')]
      .map((figure) => figure.getBoundingClientRect())
      .map(({ left, right }) => ({ left, right }))
      .sort((a, b) => a.left - b.left),
  );
}

test('stands before the WebAssembly has come, and then gets its pictures', async ({
  app,
  page,
}) => {
  let release: () => void = () => undefined;
  const held = new Promise<void>((resolve) => (release = resolve));
  await page.route('**/*.wasm', async (route) => {
    await held;
    await route.continue();
  });
  await app.open();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText(
    'See the keyposes of a motion, and which motions are alike.',
  );
  await expect(page.locator('.sample-open')).toHaveCount(4);
  await expect(app.button('Choose files')).toBeVisible();
  await expect(pictures(page)).toHaveCount(0);
  const before = await page.locator('.sample-cards').boundingBox();
  release();
  await expect(pictures(page)).toHaveCount(4);
  await expect(page.locator('.hero .figure').first()).toBeVisible();
  expect(await page.locator('.sample-cards').boundingBox()).toEqual(before);
});

test('its figures and counts are those of the samples', async ({ app, page }) => {
  const counts = sampleFiles(...offered).map((path) => reportOf(path).keyposes.length);
  await app.open();
  await expect(pictures(page)).toHaveCount(4);
  const told = await page.locator('.sample-about').allInnerTexts();
  expect(told.map((text) => Number(/\d+/.exec(text)?.[0]))).toEqual(counts);
  await expect(page.locator('.hero .figure')).toHaveCount(counts[0] ?? 0);
  await expect(page.locator('.hero-dot')).toHaveCount(counts[0] ?? 0);
});

test('no figure stands in another, and nothing overflows, at any width', async ({ app, page }) => {
  await app.open();
  await expect(pictures(page)).toHaveCount(4);
  for (const width of [1440, 1024, 800, 390, 320]) {
    await page.setViewportSize({ width, height: 800 });
    await expect
      .poll(async () => (await figureEdges(page)).at(-1)?.right ?? Infinity)
      .toBeLessThan(width - 16);
    const edges = await figureEdges(page);
    expect(edges.length).toBeGreaterThanOrEqual(Math.min(13, Math.floor(width / 150)));
    expect(edges[0]?.left).toBeGreaterThan(16);
    edges.slice(1).forEach(({ left }, index) => {
      expect(left, `figure ${index + 1} at ${width}`).toBeGreaterThan(edges[index]?.right ?? 0);
    });
    const overflow = await page.evaluate(
      () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
    );
    expect(overflow).toBe(0);
  }
});

test('each card opens its sample', async ({ app, page }) => {
  for (const [index, name] of ['slow-dance', 'tired-dance', 'walk', 'run'].entries()) {
    await app.open();
    await page.locator('.sample-open').nth(index).click();
    await app.settled();
    await expect(app.openName).toHaveText(`${name}.bvh`);
  }
});
