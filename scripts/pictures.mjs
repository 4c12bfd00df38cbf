// `npm run pictures`: the README's pictures, from the built app and our own sample. Out: docs/pictures.
import { mkdirSync } from 'node:fs';
import { chromium } from '@playwright/test';
import { preview } from 'vite';
import { chromiumArguments, findChromium } from './chromium.mjs';

const folder = 'docs/pictures';
const themes = ['light', 'dark'];
/** Long enough for a software rasteriser to draw the stage. */
const settleMs = 3000;

mkdirSync(folder, { recursive: true });
const server = await preview({ preview: { host: '127.0.0.1', port: 0 } });
const browser = await chromium.launch({
  executablePath: findChromium(),
  args: chromiumArguments,
});
for (const theme of themes) await takePictures(theme);
await browser.close();
await server.close();

/** The empty page, then the slow dance at its sixth keypose. */
async function takePictures(theme) {
  const page = await browser.newPage({
    viewport: { width: 1440, height: 900 },
    colorScheme: theme,
    locale: 'en-GB',
  });
  await page.goto(server.resolvedUrls.local[0]);
  await page.waitForTimeout(settleMs);
  await page.screenshot({ path: `${folder}/empty-${theme}.png` });
  await page.getByRole('button', { name: /slow dance/i }).click();
  await page.getByRole('slider').first().waitFor();
  for (let count = 0; count < 6; count++) await page.keyboard.press('k');
  await page.waitForTimeout(settleMs);
  await page.screenshot({ path: `${folder}/study-${theme}.png` });
  await page.close();
}
