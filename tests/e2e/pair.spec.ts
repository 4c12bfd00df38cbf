/** The pair page: two clips and more on one clock, by start, by keypose, along a path; with keys alone. */
import type { Page } from '@playwright/test';
import { sampleFiles, sampleText, temporaryFolder, writeFiles } from './support/motions';
import { clipButton, openPair, showPage } from './support/pair-page';
import { expect, test } from './support/test';

const walk = 'walk-hik-30';
const run = 'run-hik-30';

/** The times of A and B by the transport, in seconds. */
async function times(page: Page): Promise<number[]> {
  const texts = await page.locator('.pair-clock .clock-time').allInnerTexts();
  return texts.map(Number);
}

const expectTimes = (page: Page, a: number, b: number) =>
  expect.poll(() => times(page)).toEqual([a, b]);

/** The time of a card of A's or B's strip. */
async function cardTime(page: Page, clip: 0 | 1, keypose: number): Promise<number> {
  const card = page.locator('.pair-cards').nth(clip).locator('.pair-card').nth(keypose);
  return Number((await card.innerText()).trim().split(/\s+/)[1]);
}

test('the open clip and another are shown on one clock, moved by the keys of the study', async ({
  app,
  page,
}) => {
  await openPair(app, ...sampleFiles(walk, run));
  await expect(clipButton(page, 'a')).toHaveText(/A\s*walk-hik-30/);
  await expect(clipButton(page, 'b')).toHaveText(/B\s*run-hik-30/);
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await page.keyboard.press('Home');
  await expectTimes(page, 0, 0);
  await page.keyboard.press('ArrowRight');
  await expectTimes(page, 0.03, 0.03);
  await page.keyboard.press('Shift+ArrowRight');
  await expectTimes(page, 0.13, 0.13);
  await page.keyboard.press('k');
  const first = await cardTime(page, 0, 0);
  await expect.poll(async () => (await times(page))[0]).toBe(first);
  await page.keyboard.press('End');
  const ends = await times(page);
  const slider = page.locator('.pair-slider');
  const spoken = `${ends[0]?.toFixed(2)} seconds of A, ${ends[1]?.toFixed(2)} seconds of B`;
  await expect(slider).toHaveAttribute('aria-valuetext', spoken);
  await page.keyboard.press('Home');
  await page.keyboard.press('Space');
  await expect(page.getByRole('button', { name: 'Pause' })).toBeVisible();
  await expect.poll(async () => (await times(page))[1]).toBeGreaterThan(0.2);
  await page.keyboard.press('Space');
  await expect(app.button('Play')).toBeVisible();
});

test('the page opens at the first keypose of A, and so does another A', async ({ app, page }) => {
  await openPair(app, ...sampleFiles(walk, run));
  const first = await cardTime(page, 0, 0);
  expect(first).toBeGreaterThan(0);
  await expect.poll(async () => (await times(page))[0]).toBe(first);
  // Warped, B stands where it is most like that.
  await expect(page.locator('.pair-ahead')).toHaveCount(2);
  await expect.poll(async () => (await times(page))[1]).toBeGreaterThan(0);
  for (let i = 0; i < 5; i++) await page.keyboard.press('ArrowRight');
  await app.drop(...sampleFiles('slow-dance-hik-30'));
  await app.settled();
  await clipButton(page, 'a').click();
  await page.locator('#pair-clip-a .pair-list-row', { hasText: 'slow-dance' }).click();
  await expect(clipButton(page, 'a')).toHaveText(/A\s*slow-dance-hik-30/);
  await expect.poll(() => cardTime(page, 0, 0)).not.toBe(first);
  const other = await cardTime(page, 0, 0);
  await expect.poll(async () => (await times(page))[0]).toBe(other);
});

test('by keypose the clips meet where they are, or where a card is chosen', async ({
  app,
  page,
}) => {
  await openPair(app, ...sampleFiles(walk, run));
  await page.getByRole('button', { name: 'Keypose', exact: true }).click();
  await page.locator('.pair-cards').nth(0).locator('.pair-card').nth(1).click();
  const a = await cardTime(page, 0, 1);
  await expect.poll(async () => (await times(page))[0]).toBe(a);
  // B stays at the keypose that it is at.
  const current = page.locator('.pair-cards').nth(1).locator('.pair-card.current');
  const b = Number((await current.innerText()).trim().split(/\s+/)[1]);
  await expectTimes(page, a, b);
  await page.locator('.pair-cards').nth(1).locator('.pair-card').nth(2).click();
  await expectTimes(page, a, await cardTime(page, 1, 2));
});

test('a press and a drag on the rows lead the time of the clip that they are', async ({
  app,
  page,
}) => {
  await openPair(app, ...sampleFiles(walk, run));
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  const box = (await page.locator('.pair-area').boundingBox())!;
  const x = (part: number): number => box.x + part * box.width;
  await page.mouse.move(x(0.2), box.y + 110);
  await page.mouse.down();
  await expect.poll(async () => (await times(page))[0]).toBeGreaterThan(0);
  const [pressed = 0] = await times(page);
  await page.mouse.move(x(0.3), box.y + 110, { steps: 4 });
  await page.mouse.up();
  await expect.poll(async () => (await times(page))[0]).toBeGreaterThan(pressed);
  const [a = 0, b = 0] = await times(page);
  expect(b).toBeCloseTo(a, 1);
  await page.mouse.move(x(0.5), box.y + 210);
  await expect(page.locator('.pair-twin[d]')).toHaveCount(1);
});

test('warped, each moment stands beside its like: the same walk at half the rate', async ({
  app,
  page,
}) => {
  const text = sampleText(walk);
  const half = text.replace(
    /Frame Time: *([\d.]+)/,
    (_, time: string) => `Frame Time: ${2 * Number(time)}`,
  );
  await openPair(app, ...writeFiles(temporaryFolder(), { 'walk.bvh': text, 'half.bvh': half }));
  await expect(page.locator('.pair-ahead')).toHaveCount(2);
  await expect(page.locator('.pair-difference')).toBeVisible();
  const a = await cardTime(page, 0, 0);
  await expect.poll(async () => (await times(page))[0]).toBe(a);
  await expect.poll(async () => (await times(page))[1]).toBeCloseTo(2 * a, 1);
  await expect(page.locator('.pair-distance > b')).toHaveText('0');
  await expect(page.locator('.distance-sentence')).toContainText('The same.');
  // Its mirror image walks with the other foot.
  await app.button('Mirror B').click();
  await expect.poll(async () => Math.abs((await times(page))[1] - 2 * a)).toBeGreaterThan(0.1);
});

/** Seconds of A between two places of its pins. */
async function pinsApart(page: Page, first: number, second: number): Promise<number> {
  const pin = (n: number) => page.locator('.pair-pins').nth(0).locator('.pin').nth(n);
  const [a, b] = await Promise.all([pin(first).boundingBox(), pin(second).boundingBox()]);
  return (b?.x ?? 0) - (a?.x ?? 0);
}

test('the rows are zoomed by wheel and keys and show the keyposes in view; both go along', async ({
  app,
  page,
}) => {
  await openPair(app, ...sampleFiles(walk, run));
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  const all = app.button('Show both clips whole');
  await expect(all).toBeDisabled();
  const wide = await pinsApart(page, 0, 1);
  await page.keyboard.press('z');
  await expect.poll(() => pinsApart(page, 0, 1)).toBeCloseTo(2 * wide, 0);
  // What was shown keeps its place.
  const flags = page.locator('.pair-flag:not(.outside)');
  await expect(flags).toHaveCount(2);
  await page.keyboard.press('Shift+Z');
  await expect.poll(() => pinsApart(page, 0, 1)).toBeCloseTo(wide, 0);
  const box = (await page.locator('.pair-area').boundingBox())!;
  await page.mouse.move(box.x + 0.6 * box.width, box.y + 110);
  await page.keyboard.down('Control');
  for (let i = 0; i < 6; i++) await page.mouse.wheel(0, -100);
  await page.keyboard.up('Control');
  await expect(all).toBeEnabled();
  await expect(flags).toHaveCount(0);
  const cards = page.locator('.pair-cards').nth(0).locator('.pair-card');
  const shown = await cards.allInnerTexts();
  expect(shown.length).toBeGreaterThan(0);
  await page.keyboard.down('Shift');
  for (let i = 0; i < 4; i++) await page.mouse.wheel(0, 100);
  await page.keyboard.up('Shift');
  await expect.poll(() => cards.allInnerTexts()).not.toEqual(shown);
  // A key takes the view to where it leads.
  await page.keyboard.press('Home');
  await expect(flags).toHaveCount(2);
  await page.keyboard.press('0');
  await expect(all).toBeDisabled();
  await expect.poll(() => pinsApart(page, 0, 1)).toBeCloseTo(wide, 0);
});

test('study and pair hand A’s moment to each other', async ({ app, page }) => {
  await app.openWith(...sampleFiles(walk, run));
  for (let i = 0; i < 6; i++) await page.keyboard.press('ArrowRight');
  await app.expectFrame(6);
  await showPage(page, 'Pair');
  await expect.poll(async () => (await times(page))[0]).toBe(0.2);
  await page.keyboard.press('ArrowRight');
  await showPage(page, 'Study');
  await app.expectFrame(7);
});

test('clips are chosen, swapped and added by keys; a third one is superposed', async ({
  app,
  page,
}) => {
  const third = 'slow-dance-hik-30';
  await openPair(app, ...sampleFiles(walk, run, third));
  await clipButton(page, 'b').focus();
  await page.keyboard.press('Enter');
  const list = page.locator('#pair-clip-b');
  await expect(list.getByRole('searchbox')).toBeFocused();
  await page.keyboard.type('slow');
  await expect(list.locator('.pair-list-row')).toHaveCount(1);
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await expect(clipButton(page, 'b')).toHaveText(/B\s*slow-dance-hik-30/);
  await app.button('Swap A and B').click();
  await expect(clipButton(page, 'a')).toHaveText(/A\s*slow-dance-hik-30/);
  await expect(clipButton(page, 'b')).toHaveText(/B\s*walk-hik-30/);
  await clipButton(page, 'more').click();
  await page.locator('#pair-clip-more .pair-list-row', { hasText: run }).click();
  await expect(clipButton(page, 'more')).toHaveText('1');
  await expect(app.button('Superposed')).toHaveAttribute('aria-pressed', 'true');
  await expect(page.locator('.pair-plate')).toHaveCount(3);
  await page.locator('#pair-clip-more .pair-list-row', { hasText: run }).click();
  await page.keyboard.press('Escape');
  await app.button('Side by side').click();
  await expect(page.locator('.pair-plate')).toHaveCount(2);
});

test('two that cannot be compared say so', async ({ app, page }) => {
  const text = sampleText(walk);
  const [still] = text.split(/(?<=Frame Time:[^\n]*\n[^\n]*\n)/);
  const one = (still ?? '').replace(/Frames: *\d+/, 'Frames: 1');
  await openPair(app, ...writeFiles(temporaryFolder(), { 'one.bvh': one, 'walk.bvh': text }));
  await expect(page.locator('.pair-note')).toHaveText('These two cannot be compared.');
});

test('one clip alone asks for another', async ({ app, page }) => {
  await openPair(app, ...sampleFiles(walk));
  await expect(page.locator('.stage-sentence:visible').last()).toContainText(
    'Choose a second clip',
  );
  await expect(page.locator('.pair-rows')).toBeHidden();
  await app.drop(...sampleFiles(run));
  await expect(page.locator('.pair-rows')).toBeVisible();
});
