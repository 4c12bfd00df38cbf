/** Over the rows of a pair: the A–B loop made, moved and cleared; the part shown while they are zoomed; namesakes. */
import type { Page } from '@playwright/test';
import { sampleFiles, sampleText, temporaryFolder, writeFiles } from './support/motions';
import { clipButton, openPair } from './support/pair-page';
import { expect, test } from './support/test';

const walk = 'walk-hik-30';
const run = 'run-hik-30';

/** Heights of the rows: A's ruler and B's, and the lines between. */
const rulerA = 133;
const rulerB = 187;
const between = 160;

async function areaOf(page: Page): Promise<{ x: number; y: number; width: number }> {
  const area = page.locator('.pair-area');
  await area.scrollIntoViewIfNeeded();
  return (await area.boundingBox())!;
}

async function drag(page: Page, y: number, from: number, to: number): Promise<void> {
  const area = await areaOf(page);
  await page.mouse.move(area.x + from, area.y + y);
  await page.mouse.down();
  await page.mouse.move(area.x + (from + to) / 2, area.y + y, { steps: 3 });
  await page.mouse.move(area.x + to, area.y + y, { steps: 3 });
  await page.mouse.up();
}

const loop = (page: Page) => page.locator('.loop-range');
const end = (page: Page, name: 'A' | 'B', clip: 'A' | 'B') => {
  const does = name === 'A' ? 'begins' : 'ends';
  return page.getByRole('slider', { name: `${name}, where the loop ${does}, in ${clip}'s time` });
};
const value = async (page: Page, name: 'A' | 'B', clip: 'A' | 'B'): Promise<number> =>
  Number(await end(page, name, clip).getAttribute('aria-valuenow'));

test('a drag on a ruler makes a loop, which its tabs move, and two clicks or Escape clear', async ({
  app,
  page,
}) => {
  await openPair(app, ...sampleFiles(walk, run));
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await expect(page.locator('.pair-loop')).toBeHidden();
  await drag(page, rulerA, 200, 400);
  await expect(page.locator('.pair-loop')).toBeVisible();
  await expect(loop(page)).toHaveText(/^\d\.\d\d–\d\.\d\d s$/);
  const [a, b] = [await value(page, 'A', 'A'), await value(page, 'B', 'A')];
  expect(b).toBeGreaterThan(a + 5);
  // From the start on both have one time.
  expect(await value(page, 'A', 'B')).toBe(a);
  await end(page, 'B', 'B').focus();
  await page.keyboard.press('ArrowRight');
  await expect.poll(() => value(page, 'B', 'A')).toBe(b + 1);
  const box = (await end(page, 'A', 'A').boundingBox())!;
  await page.mouse.move(box.x + 6, box.y + 8);
  await page.mouse.down();
  await page.mouse.move(box.x - 60, box.y + 8, { steps: 3 });
  await page.mouse.up();
  await expect.poll(() => value(page, 'A', 'B')).toBeLessThan(a);
  const area = await areaOf(page);
  await page.mouse.dblclick(area.x + 300, area.y + between);
  await expect(page.locator('.pair-loop')).toBeHidden();
  await drag(page, rulerB, 240, 100);
  await expect(end(page, 'A', 'B')).toBeVisible();
  await page.locator('body').evaluate(() => (document.activeElement as HTMLElement).blur());
  await page.keyboard.press('Escape');
  await expect(end(page, 'A', 'B')).toBeHidden();
});

test('a loop keeps its moments of A when the clips are synchronised otherwise', async ({
  app,
  page,
}) => {
  await openPair(app, ...sampleFiles(walk, run));
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await drag(page, rulerA, 200, 400);
  await expect(loop(page)).toBeVisible();
  const before = await loop(page).innerText();
  const ofB = await value(page, 'B', 'B');
  await page.getByRole('button', { name: 'Time warp', exact: true }).click();
  await expect(page.locator('.pair-ahead')).toHaveCount(2);
  await expect.poll(() => value(page, 'B', 'B')).not.toBe(ofB);
  await expect(loop(page)).toHaveText(before);
});

test('a press on a ruler goes there, a drag of the flag on it scrubs', async ({ app, page }) => {
  await openPair(app, ...sampleFiles(walk, run));
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  const area = await areaOf(page);
  await page.mouse.click(area.x + 400, area.y + rulerA);
  const flag = page.locator('.pair-flag rect').first();
  const at = async () => Math.round((await flag.boundingBox())!.x + 23 - area.x);
  await expect.poll(async () => Math.abs((await at()) - 400)).toBeLessThan(10);
  const x = await at();
  await drag(page, rulerA, x, x + 100);
  await expect.poll(async () => Math.abs((await at()) - x - 100)).toBeLessThan(10);
  await expect(page.locator('.pair-loop')).toBeHidden();
});

test('tabs of a short loop stand beside each other and beside the flags of time', async ({
  app,
  page,
}) => {
  await openPair(app, ...sampleFiles(walk, run));
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  for (const key of ['[', 'ArrowRight', ']']) await page.keyboard.press(key);
  for (const clip of ['A', 'B'] as const) {
    const flag = page.locator('.pair-flag rect').nth(clip === 'A' ? 0 : 1);
    const [a, b, time] = await Promise.all(
      [end(page, 'A', clip), end(page, 'B', clip), flag].map(
        async (one) => (await one.boundingBox())!,
      ),
    );
    expect(a.x + a.width).toBeLessThanOrEqual(b.x + 0.5);
    const apart = clip === 'A' ? a.y - (time.y + time.height) : time.y - (a.y + a.height);
    expect(apart).toBeGreaterThanOrEqual(-0.5);
  }
});

test('zoomed, a bar at each strip shows the part of its clip and moves it', async ({
  app,
  page,
}) => {
  await openPair(app, ...sampleFiles(walk, run));
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  const bar = page.getByRole('scrollbar', { name: 'The part of A that the rows show' });
  await expect(bar).toBeHidden();
  for (const press of ['Home', 'z', 'z']) await page.keyboard.press(press);
  await expect(bar).toBeVisible();
  await expect(bar).toHaveAttribute('aria-controls', 'pair-area');
  await expect(bar).toHaveAttribute('aria-valuetext', /^0\.0 to \d\.\d of \d\.\d seconds$/);
  const place = () => bar.getAttribute('aria-valuenow').then(Number);
  expect(await place()).toBe(0);
  await bar.focus();
  await page.keyboard.press('End');
  await expect.poll(place).toBe(100);
  await page.keyboard.press('Home');
  await expect.poll(place).toBe(0);
  const thumb = (await bar.locator('.pair-span-thumb').boundingBox())!;
  await page.mouse.move(thumb.x + 20, thumb.y + 2);
  await page.mouse.down();
  await page.mouse.move(thumb.x + 120, thumb.y + 2, { steps: 4 });
  await page.mouse.up();
  await expect.poll(place).toBeGreaterThan(10);
  await page.keyboard.press('Shift+Z');
  await page.keyboard.press('Shift+Z');
  await expect(bar).toBeHidden();
});

test('clips of one name are told apart by what the library tells them apart by', async ({
  app,
  page,
}) => {
  const [one, other] = [sampleText(walk), sampleText(run)];
  const folder = temporaryFolder();
  writeFiles(folder, { 'monday/take.bvh': one, 'tuesday/take.bvh': other });
  await openPair(app, folder);
  await expect(clipButton(page, 'a')).toHaveText(/take.*(monday|tuesday)/s);
  for (const day of ['monday', 'tuesday']) {
    await expect(page.locator('.pair-plate', { hasText: day })).toHaveCount(1);
    await expect(page.locator('.pair-row-clip', { hasText: day })).toHaveCount(1);
  }
});
