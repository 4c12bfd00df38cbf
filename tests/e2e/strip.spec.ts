/** The strip of a clip with more keyposes than cards fit, and of a part of one. */
import type { Locator } from '@playwright/test';
import { longText, sampleFiles, temporaryFolder, writeFiles } from './support/motions';
import { keyposeFramesOf, reportOf } from './support/reports';
import { expect, test } from './support/test';

const numbersOf = async (cards: Locator): Promise<number[]> =>
  (await cards.locator('.card-number').allInnerTexts()).map(Number);

const ascending = (numbers: readonly number[]): boolean =>
  numbers.every((number, index) => index === 0 || number > (numbers[index - 1] ?? 0));

test('the most intense that fit, in time order; their texts stay in their cards', async ({
  app,
  page,
}) => {
  const [path = ''] = writeFiles(temporaryFolder(), { 'long.bvh': longText('walk-hik-30', 2e6) });
  const report = reportOf(path);
  const frames = keyposeFramesOf(report);
  expect(frames.length).toBeGreaterThan(60);
  await app.openWith(path);
  const strip = app.section('Keyposes');
  const cards = strip.locator('.keypose-card');
  const shown = await cards.count();
  await expect(strip).toContainText(`${shown} of ${frames.length} shown`);
  const numbers = await numbersOf(cards);
  expect(ascending(numbers)).toBe(true);
  const intensityOf = (number: number): number => report.keyposes[number - 1]?.intensity ?? 0;
  const least = Math.min(...numbers.map(intensityOf));
  const hidden = frames.map((_, index) => index + 1).filter((n) => !numbers.includes(n));
  expect(Math.max(...hidden.map(intensityOf))).toBeLessThanOrEqual(least + 1e-9);
  await expect(strip.locator('.thread')).toHaveCount(shown);
  await expect(strip.locator('.keypose-card .figure')).toHaveCount(shown);

  const overflow = await cards.evaluateAll((buttons) => {
    const area = buttons[0].closest('.strip-area')!.getBoundingClientRect();
    return buttons.filter((button) => {
      const card = button.getBoundingClientRect();
      const range = document.createRange();
      range.selectNodeContents(button.querySelector('.card-label')!);
      const text = range.getBoundingClientRect();
      return text.width > card.width || card.left < area.left || card.right > area.right;
    }).length;
  });
  expect(overflow).toBe(0);

  // The arrow keys go through all of them, shown or not.
  await cards.first().focus();
  await page.keyboard.press('Enter');
  await app.expectFrame(frames[numbers[0] - 1] ?? -1);
  for (let step = 0; step < 6; step++) {
    await page.keyboard.press('ArrowRight');
    await app.expectFrame(frames[numbers[0] + step] ?? -1);
    await expect(page.locator('.keypose-card.current')).toBeFocused();
    await expect(page.locator('.keypose-card.current .figure')).toBeAttached();
  }
});

test('zoomed in: the keyposes of the span, and the keys scroll to the others', async ({
  app,
  page,
}) => {
  const [path = ''] = sampleFiles('slow-dance-hik-60');
  const frames = keyposeFramesOf(reportOf(path));
  await app.openWith(path);
  await page.keyboard.press('Home');
  for (let n = 0; n < 3; n++) await page.keyboard.press('z');
  const cards = page.locator('.keypose-card');
  await expect.poll(() => cards.count()).toBeLessThan(frames.length);
  const first = await numbersOf(cards);
  expect(first).toEqual(first.map((_, index) => index + 1));
  await cards.first().focus();
  for (let number = 2; number <= frames.length; number++) await page.keyboard.press('ArrowRight');
  await app.expectFrame(frames.at(-1) ?? -1);
  await expect(page.locator('.keypose-card.current')).toBeFocused();
  expect((await numbersOf(cards)).at(-1)).toBe(frames.length);
  await page.keyboard.press('0');
  await expect(cards).toHaveCount(frames.length);
});

test('the moment of the card under the pointer shows on the timeline', async ({ app, page }) => {
  const [path = ''] = sampleFiles('walk-hik-60');
  const frames = keyposeFramesOf(reportOf(path));
  await app.openWith(path);
  await page.locator('.keypose-card').nth(2).hover();
  const flag = page.locator('.hover-flag');
  await expect(flag).toBeVisible();
  await expect(flag).toHaveText(((frames[2] ?? 0) / 60).toFixed(3));
  await page.mouse.move(10, 10);
  await expect(flag).toBeHidden();
});
