// `npm run pictures`: the README's pictures, from the built app and our own samples. Out: docs/pictures.
import { mkdirSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { withPage } from './page.mjs';
import { run } from './process.mjs';

const folder = 'docs/pictures';
/** Long enough for a software rasteriser to draw the stage. */
const settleMs = 3000;

/** The empty page, then the slow dance at its eighth keypose. */
function takePictures(colorScheme) {
  const context = { viewport: { width: 1440, height: 900 }, colorScheme, locale: 'en-GB' };
  return withPage(context, async (page, address) => {
    await page.goto(address);
    await page.waitForTimeout(settleMs);
    await page.screenshot({ path: `${folder}/empty-${colorScheme}.png` });
    await page.getByRole('button', { name: /slow dance/i }).click();
    await page.getByRole('slider').first().waitFor();
    await page.mouse.move(0, 0);
    for (let count = 0; count < 8; count++) await page.keyboard.press('k');
    await page.waitForTimeout(settleMs);
    await page.screenshot({ path: `${folder}/study-${colorScheme}.png` });
  });
}

/** Two clips by their names; then the pointer stands over their cell, which shows its tip. */
async function choosePair(page, a, b) {
  const name = (of) => page.getByRole('option', { name: new RegExp(`^${of},`) });
  await name(a).click();
  await name(b).click({ modifiers: ['Shift'] });
  await page.locator('.distance-sentence').waitFor();
  const ring = await page.locator('.matrix-ring.selected:not([hidden])').boundingBox();
  await page.mouse.move(ring.x + ring.width / 2, ring.y + ring.height / 2);
  await page.locator('.tip-distance').waitFor();
}

/** All samples compared, labelled by their motion; then two of them side by side. */
function takeComparison(colorScheme, files) {
  const context = { viewport: { width: 1440, height: 900 }, colorScheme, locale: 'en-GB' };
  return withPage(context, async (page, address) => {
    await page.goto(address);
    await page.locator('input[type=file]').first().setInputFiles(files);
    await page.getByRole('slider').first().waitFor();
    await page.waitForTimeout(2 * settleMs);
    await page.locator('.page-tab').nth(1).click();
    await page.waitForTimeout(settleMs);
    await page.locator('[popovertarget="labels-menu"]').click();
    await page.getByRole('menuitemradio', { name: /file name/ }).click();
    await page.getByRole('dialog').getByRole('textbox').fill('{label}-*');
    await page.keyboard.press('Enter');
    await choosePair(page, 'slow-dance-hik-60', 'tired-dance-hik-60');
    await page.waitForTimeout(settleMs);
    await page.screenshot({ path: `${folder}/compare-${colorScheme}.png` });
    await page.locator('.page-tab').nth(2).click();
    await page.waitForTimeout(settleMs);
    for (let count = 0; count < 3; count++) await page.keyboard.press('k');
    // No ring around what was pressed before the keys.
    await page.evaluate(() => document.activeElement.blur());
    await page.waitForTimeout(settleMs);
    await page.screenshot({ path: `${folder}/pair-${colorScheme}.png` });
  });
}

mkdirSync(folder, { recursive: true });
await takePictures('light');
await takePictures('dark');

const samples = mkdtempSync(join(tmpdir(), 'keypose-samples-'));
try {
  run('cargo', ['run', '--release', '--quiet', '-p', 'keypose-cli', '--', 'samples', samples]);
  const files = readdirSync(samples)
    .filter((name) => name.endsWith('.bvh'))
    .map((name) => join(samples, name));
  await takeComparison('light', files);
  await takeComparison('dark', files);
} finally {
  rmSync(samples, { recursive: true });
}
