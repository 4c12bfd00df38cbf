/** The stages of the page Pair, drawn by software: a small stage, and time. */
import { watchDrawing } from './support/drawn';
import { sampleFiles, sampleText, temporaryFolder, writeFiles } from './support/motions';
import { clipButton, showPage } from './support/pair-page';
import { expect, test } from './support/test';

const walk = 'walk-hik-30';
const run = 'run-hik-30';

test.use({ viewport: { width: 1040, height: 640 }, deviceScaleFactor: 1 });
test.setTimeout(120_000);

test('clips that come to the stage stand at their moment, not at their start', async ({
  app,
  page,
}) => {
  const text = sampleText(walk);
  const names = ['one.bvh', 'two.bvh', 'three.bvh'];
  const files = Object.fromEntries(names.map((name) => [name, text]));
  await app.open('');
  await app.drop(...writeFiles(temporaryFolder(), files));
  await app.settled();
  await showPage(page, 'Pair');
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await page.keyboard.press('End');
  await expect(page.locator('.stage-tag.current:visible').first()).toBeVisible();
  await clipButton(page, 'more').click();
  await page.locator('#pair-clip-more .pair-list-row[aria-pressed="false"]').click();
  await page.keyboard.press('Escape');
  const letters = page.locator('.stage-tag.letter:visible');
  await expect(letters).toHaveCount(3);
  // They are one motion: they stand in one place, their letters side by side.
  const places = () =>
    letters.evaluateAll((all) => all.map((tag) => tag.getBoundingClientRect().x));
  await expect
    .poll(async () => Math.max(...(await places())) - Math.min(...(await places())))
    .toBeLessThan(60);
});

test('numbers on the ground stay clear of the words', async ({ app, page }) => {
  await app.open('');
  await app.drop(...sampleFiles(walk, run));
  await app.settled();
  await showPage(page, 'Pair');
  const stage = page.locator('.pair-stage').first();
  const caption = stage.locator('.stage-caption');
  await expect(caption).toBeVisible();
  const tag = stage.locator('.stage-tag.current');
  await expect(tag).toBeVisible();
  const bottom = async () => {
    const box = await tag.boundingBox();
    return (box?.y ?? 0) + (box?.height ?? 0);
  };
  await expect.poll(bottom).toBeLessThanOrEqual((await caption.boundingBox())!.y);
});

test('twenty clips of other rates stand on one stage within thirty draw calls', async ({
  app,
  page,
}) => {
  const drawn = await watchDrawing(page, { paints: false });
  const text = sampleText(walk);
  const names = Array.from({ length: 20 }, (_, i) => `clip-${String(i).padStart(2, '0')}.bvh`);
  const slower = (i: number): string =>
    text.replace(
      /Frame Time: *([\d.]+)/,
      (_, time) => `Frame Time: ${Number(time) * (1 + i / 10)}`,
    );
  const files = Object.fromEntries(names.map((name, i) => [name, slower(i)]));
  await app.open('');
  await app.drop(...writeFiles(temporaryFolder(), files));
  await app.settled();
  await showPage(page, 'Pair');
  await clipButton(page, 'more').click();
  const rows = page.locator('#pair-clip-more .pair-list-row');
  for (let i = 0; i < 20; i++)
    if ((await rows.nth(i).getAttribute('aria-pressed')) === 'false') await rows.nth(i).click();
  await expect(clipButton(page, 'more')).toHaveText('18');
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await expect(page.locator('.stage-tag.letter:visible')).toHaveCount(20);
  for (let i = 0; i < 3; i++) await page.keyboard.press('Shift+ArrowRight');
  await expect.poll(async () => (await drawn()).calls).toBeGreaterThanOrEqual(22);
  expect((await drawn()).calls).toBeLessThanOrEqual(30);
  expect((await drawn()).uniformVectors).toBeLessThanOrEqual(224);
});
