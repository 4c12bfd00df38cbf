/** The page Compare: matrix, tree, names and map of a set, by pointer and by keys alone. */
import type { Page } from '@playwright/test';
import {
  sampleBytes,
  sampleFiles,
  sixSamples as set,
  temporaryFolder,
  tinyBvh,
  writeFiles,
} from './support/motions';
import { expect, test } from './support/test';
import type { AppPage } from './support/app-page';

async function openCompare(app: AppPage, page: Page, ...more: string[]): Promise<void> {
  await app.openWith(...sampleFiles(...set), ...more);
  await page.getByRole('button', { name: 'Compare', exact: true }).click();
  await expect(page.getByRole('grid', { name: 'Matrix of distances' })).toBeVisible();
  await expect(names(page)).toHaveCount(set.length);
}

const names = (page: Page) =>
  page.getByRole('listbox', { name: 'Clips in the order of the matrix' }).getByRole('option');
const slider = (page: Page) => page.getByRole('slider', { name: 'Cut of the tree' });
const cell = (page: Page) => page.getByRole('gridcell');

test('matrix, tree and map show the set; the selection is one', async ({ app, page }) => {
  await openCompare(app, page);
  const first = names(page).nth(0);
  const third = names(page).nth(2);
  const text = async (at: number): Promise<string> =>
    ((await names(page).nth(at).getAttribute('aria-label')) ?? '').split(',')[0];
  await first.click();
  await third.click({ modifiers: ['Shift'] });
  expect(await page.evaluate(() => getSelection()?.toString())).toBe('');
  await expect(first).toHaveAttribute('aria-selected', 'true');
  await expect(third).toHaveAttribute('aria-selected', 'true');
  await expect(page.locator('.clip.open .clip-name')).toHaveAttribute(
    'title',
    new RegExp(`${await text(0)}\\.bvh$`),
  );
  await expect(page.locator('.map-pill')).toHaveText(/^0\.\d{4,}$/);
  await expect(page.locator('.map-figure').first()).toBeVisible();
  await expect(page.locator('.map-spread')).toHaveText(/^\d+ % of the spread$/);
  // The cells on the diagonal have the colour of the page, as style sheets may shorten it.
  const diagonal = await page.evaluate(() => {
    const canvas = document.querySelector<HTMLCanvasElement>('.matrix-canvas');
    const top = (canvas?.height ?? 0) - (canvas?.width ?? 0);
    return [...(canvas?.getContext('2d')?.getImageData(1, top + 1, 1, 1).data ?? [])];
  });
  expect(diagonal).toEqual([255, 255, 255, 255]);
  const marks = await page.evaluate(() => performance.getEntriesByName('comparison-first-picture'));
  expect(marks).toHaveLength(1);
});

test('the top bar says how many are compared, on Compare alone', async ({ app, page }) => {
  await openCompare(app, page);
  const counts = page.locator('.top-counts');
  await expect(counts).toHaveText(/^\s*6 clips\s+15 pairs\s*$/);
  await page.getByRole('button', { name: 'Study', exact: true }).click();
  await expect(counts).toBeHidden();
});

test('the focus ring of the pages stands whole inside the top bar', async ({ app, page }) => {
  await openCompare(app, page);
  for (const name of ['Study', 'Compare', 'Pair']) {
    const tab = page.locator('.page-tab', { hasText: name });
    await page.keyboard.press('Tab');
    await tab.focus();
    const room = await tab.evaluate((element) => {
      const { outlineOffset, outlineWidth, outlineStyle } = getComputedStyle(element);
      const ring = parseFloat(outlineOffset) + parseFloat(outlineWidth);
      const [own, bar] = [element, element.closest('.top-bar')!].map((one) =>
        one.getBoundingClientRect(),
      );
      return {
        outlineStyle,
        above: own.top - bar.top - ring,
        below: bar.bottom - own.bottom - ring,
      };
    });
    expect(room.outlineStyle, name).toBe('solid');
    expect(room.above, name).toBeGreaterThanOrEqual(0);
    expect(room.below, name).toBeGreaterThanOrEqual(0);
  }
});

test('a cell shows its pair in a tip, selects it by a click and opens it by two', async ({
  app,
  page,
}) => {
  await openCompare(app, page);
  const grid = page.getByRole('grid', { name: 'Matrix of distances' });
  const box = (await grid.boundingBox())!;
  const at = { x: 4, y: box.height - 6 };
  await grid.hover({ position: at });
  const tip = page.locator('.matrix-pane .pair-tip');
  await expect(tip.locator('.tip-distance')).toHaveText(/^0\.\d{4,}$/);
  await expect(tip.locator('.tip-rank')).toHaveText(/^\d+(st|nd|rd|th) of 15 pairs$/);
  await expect(tip.locator('.tip-figure path').first()).toBeVisible();
  await grid.click({ position: at });
  await expect(names(page).nth(0)).toHaveAttribute('aria-selected', 'true');
  await expect(names(page).nth(set.length - 1)).toHaveAttribute('aria-selected', 'true');
  await grid.dblclick({ position: at });
  await expect(page.locator('#pair')).toBeVisible();
});

test('the cut is dragged, moved by keys and set back', async ({ app, page }) => {
  await openCompare(app, page);
  const cut = slider(page);
  const before = Number(await cut.getAttribute('aria-valuenow'));
  await cut.focus();
  await page.keyboard.press('End');
  await expect(cut).toHaveAttribute('aria-valuetext', '6 clusters');
  await page.keyboard.press('Home');
  await expect(cut).toHaveAttribute('aria-valuetext', '1 cluster');
  await page.keyboard.press('ArrowRight');
  await expect(cut).toHaveText('2 clusters');
  const box = (await cut.boundingBox())!;
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 300, box.y + box.height / 2, { steps: 6 });
  await page.mouse.up();
  await expect(cut).toHaveText('6 clusters');
  await page.getByRole('button', { name: 'auto', exact: true }).click();
  await expect(cut).toHaveAttribute('aria-valuenow', String(before));
  await expect(page.getByRole('button', { name: 'auto', exact: true })).toHaveCount(0);
});

test('by keys alone: through the matrix, the names and the map', async ({ app, page }) => {
  await openCompare(app, page);
  await cell(page).focus();
  await page.keyboard.press('Control+Home');
  await page.keyboard.press('ArrowRight');
  await expect(cell(page)).toBeFocused();
  await expect(cell(page)).toHaveAttribute('aria-colindex', '3');
  await expect(cell(page)).toHaveAttribute(
    'aria-label',
    /^.+ with .+, 0\.\d{4,}, \d+(st|nd|rd|th) of 15 pairs$/,
  );
  await expect(page.getByRole('rowheader')).toHaveCount(1);
  await expect(page.getByRole('columnheader')).toHaveCount(1);
  await page.keyboard.press(' ');
  await expect(names(page).nth(0)).toHaveAttribute('aria-selected', 'true');
  await expect(names(page).nth(1)).toHaveAttribute('aria-selected', 'true');

  await names(page).nth(0).focus();
  await page.keyboard.press('End');
  await page.keyboard.press('Shift+Enter');
  await expect(names(page).nth(set.length - 1)).toBeFocused();
  await expect(names(page).nth(set.length - 1)).toHaveAttribute('aria-selected', 'true');

  const map = page.getByRole('group', { name: 'Map of the clips: near is alike' });
  const point = map.getByRole('button');
  await point.focus();
  const start = await point.getAttribute('aria-label');
  expect(start).toMatch(/^.+, no label, cluster \d$/);
  const visited = new Set([start]);
  for (const key of ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown']) {
    await page.keyboard.press(key);
    await expect(point).toBeFocused();
    visited.add(await point.getAttribute('aria-label'));
  }
  expect(visited.size).toBeGreaterThan(1);

  await cell(page).focus();
  await page.keyboard.press('Control+Home');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  await expect(page.locator('#pair')).toBeVisible();
});

test('by name the rows stand in the order of the names, without a tree', async ({ app, page }) => {
  await openCompare(app, page);
  await page.getByRole('radio', { name: 'Name' }).click();
  const sorted = [...set].sort();
  await expect
    .poll(() => names(page).evaluateAll((rows) => rows.map((row) => row.getAttribute('title'))))
    .toEqual(sorted);
  await expect(slider(page)).toBeHidden();
  await page.getByRole('radio', { name: 'Name' }).press('ArrowRight');
  await expect(page.getByRole('radio', { name: 'Tree' })).toHaveAttribute('aria-checked', 'true');
  await expect(slider(page)).toBeVisible();
});

test('what cannot be compared stands apart with its reason', async ({ app, page }) => {
  const files = { 'prop.bvh': tinyBvh(60), 'pose.bvh': tinyBvh(1) };
  await openCompare(app, page, ...writeFiles(temporaryFolder(), files));
  await page.getByRole('button', { name: '2 clips stand apart' }).click();
  const list = page.locator('#apart-list');
  await expect(list.locator('li')).toHaveCount(2);
  await expect(list).toContainText('not a human body');
  await expect(list).toContainText('one frame only');
});

test('one clip alone is told to want another', async ({ app, page }) => {
  await app.openWith(...sampleFiles('walk-hik-30'));
  await page.getByRole('button', { name: 'Compare', exact: true }).click();
  await expect(page.locator('.compare-message')).toHaveText(
    'Two clips with a human body can be compared: drop another.',
  );
});

test('the map is enlarged, zoomed and brought back; a removed clip leaves the others in place', async ({
  app,
  page,
}) => {
  await openCompare(app, page);
  await page.getByRole('button', { name: 'Enlarge the map' }).click();
  await expect(page.locator('.matrix-pane')).toBeHidden();
  const map = page.getByRole('group', { name: 'Map of the clips: near is alike' });
  await map.getByRole('button').focus();
  await page.keyboard.press('+');
  await expect(page.getByRole('button', { name: 'Show the whole map' })).toBeVisible();
  await page.keyboard.press('0');
  await expect(page.getByRole('button', { name: 'Show the whole map' })).toHaveCount(0);
  await page.keyboard.press('Escape');
  await expect(page.locator('.matrix-pane')).toBeVisible();
  await app.row('run-poser-30.bvh').locator('.clip-open').focus();
  await page.keyboard.press('Delete');
  await expect(names(page)).toHaveCount(set.length - 1);
});

/** Enough for cells that can be made larger. */
async function openMany(app: AppPage, page: Page): Promise<void> {
  const folder = temporaryFolder();
  const walk = sampleBytes('walk-hik-30');
  const many = Array.from({ length: 90 }, (_, n) => [`m${n}.bvh`, walk] as const);
  writeFiles(folder, Object.fromEntries(many));
  await app.openWith(folder);
  await page.locator('.page-tab', { hasText: 'Compare' }).click();
  await expect(page.locator('.compare.compared')).toBeVisible();
}

const scrolled = (page: Page): Promise<number> =>
  page.locator('.compare').evaluate(({ scrollTop }) => scrollTop);

test('where the page does not scroll, the wheel zooms the matrix', async ({ app, page }) => {
  await openMany(app, page);
  await expect(app.button('Zoom out')).toBeDisabled();
  await page.locator('.matrix-grid').hover();
  await page.mouse.wheel(0, -300);
  await expect(app.button('Zoom out')).toBeEnabled();
});

test.describe('a window in which the page scrolls', () => {
  test.use({ viewport: { width: 1024, height: 768 } });

  test('the wheel scrolls it, over matrix and map too; with Ctrl it zooms them', async ({
    app,
    page,
  }) => {
    await openMany(app, page);
    await page.locator('.matrix-grid').hover();
    await page.mouse.wheel(0, 200);
    await expect.poll(() => scrolled(page)).toBe(200);
    await expect(app.button('Zoom out')).toBeDisabled();
    await page.locator('.matrix-grid').hover();
    const before = await scrolled(page);
    await page.keyboard.down('Control');
    await page.mouse.wheel(0, -300);
    await page.keyboard.up('Control');
    await expect(app.button('Zoom out')).toBeEnabled();
    expect(await scrolled(page)).toBe(before);
    await page.locator('.map-input').hover();
    const atMap = await scrolled(page);
    await page.mouse.wheel(0, -100);
    await expect.poll(() => scrolled(page)).toBe(atMap - 100);
    await expect(app.button('Show the whole map')).toHaveCount(0);
  });
});
