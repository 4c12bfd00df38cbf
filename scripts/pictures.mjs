// `npm run pictures`: the README's pictures, from the built app and our own sample. Out: docs/pictures.
import { mkdirSync } from 'node:fs';
import { withPage } from './page.mjs';

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

mkdirSync(folder, { recursive: true });
await takePictures('light');
await takePictures('dark');
