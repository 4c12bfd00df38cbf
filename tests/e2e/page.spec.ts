/** The page by itself: it opens, keeps its own policy, asks nothing of anyone else, and works anywhere. */
import { join } from 'node:path';
import { serveFolder } from '../support/static-server';
import { sampleFiles } from './support/motions';
import { expect, test } from './support/test';

const dist = join(import.meta.dirname, '..', '..', 'dist');

test('the watch of all these tests sees what it watches for', async ({ app, page, faults }) => {
  await app.open();
  await page.waitForLoadState('networkidle');
  expect(faults).toEqual([]);
  await page.evaluate(() => fetch('https://example.com/').catch(() => undefined));
  await expect.poll(() => faults.join()).toContain('violates');
  faults.length = 0;
  await page.evaluate(() => {
    document.body.insertAdjacentHTML('beforeend', '<p style="color: red">red</p>');
  });
  await expect.poll(() => faults.join()).toContain('style');
  faults.length = 0;
  await page.evaluate(() => window.open('http://localhost:9/'));
  await expect.poll(() => faults.join()).toContain('request: http://localhost:9/');
  faults.length = 0;
});

test('under a path of a host that is nothing but a folder of files', async ({ app, page }) => {
  const host = await serveFolder(dist, '/museum/dances/');
  const missing: string[] = [];
  page.on('response', (response) => {
    if (!response.ok()) missing.push(response.url());
  });
  try {
    await page.goto(host.address);
    await page.locator('.sample-open').first().click();
    await expect(page.locator('.keypose-card').first()).toBeVisible();
    await expect(page.locator('canvas').first()).toBeVisible();
    await app.drop(...sampleFiles('walk-hik-30'));
    await expect(app.row('walk-hik-30.bvh')).toContainText('10 keyposes');
    expect(missing).toEqual([]);
  } finally {
    await host.stop();
  }
});

test('the samples of the empty page open and play', async ({ app, page }) => {
  await app.open();
  const cards = page.locator('.sample-open');
  await expect(cards).toHaveCount(4);
  await expect(cards.first()).toContainText(/A slow dance\s*\d+ keyposes, where it holds still/);
  await cards.nth(1).click();
  await app.settled();
  await expect(app.section('Result')).toContainText(/\d+ keyposes/);
  await page.keyboard.press('Home');
  await app.button('Play').click();
  await expect.poll(() => app.frame()).toBeGreaterThan(10);
  await app.button('Pause').click();
});

test('the stage shows a figure that moves', async ({ app, page }) => {
  await page.setViewportSize({ width: 700, height: 620 });
  await app.open('');
  await app.drop(...sampleFiles('walk-hik-30'));
  const canvas = page.locator('#stage-figure canvas');
  await expect(app.caption).toContainText('of 10');
  await expect(canvas).toBeVisible();
  const drawn = async (): Promise<string> => (await canvas.screenshot()).toString('base64');
  /** Pixels in a colour: ground and grid are grey, a figure's sides are not. */
  const figurePixels = async (): Promise<number> =>
    page.evaluate(
      async (base64) => {
        const image = new Image();
        image.src = `data:image/png;base64,${base64}`;
        await image.decode();
        const { width, height } = image;
        const context = new OffscreenCanvas(width, height).getContext('2d')!;
        context.drawImage(image, 0, 0);
        const { data } = context.getImageData(0, 0, width, height);
        let strong = 0;
        for (let at = 0; at < data.length; at += 4) {
          const [red = 0, green = 0, blue = 0] = data.subarray(at, at + 3);
          if (Math.max(red, green, blue) - Math.min(red, green, blue) > 60) strong += 1;
        }
        return strong;
      },
      await drawn(),
    );
  await expect.poll(figurePixels).toBeGreaterThan(300);
  await page.keyboard.press('Home');
  const first = await drawn();
  await page.keyboard.press('End');
  await expect.poll(drawn).not.toBe(first);
  await app.button('Top').click();
  await expect(app.button('Top')).toHaveAttribute('aria-pressed', 'true');
  await expect.poll(figurePixels).toBeGreaterThan(100);
});
