/** What goes wrong is told and takes nothing with it. */
import { zipSync } from 'fflate';
import { sampleFiles, temporaryFolder, writeFiles } from './support/motions';
import { expect, test } from './support/test';

test('an error in the page is told in a sentence, and the page goes on', async ({
  app,
  page,
  faults,
}) => {
  await app.openWith(...sampleFiles('walk-hik-30'));
  await page.evaluate(() => {
    setTimeout(() => {
      throw new Error('a seam came open');
    });
  });
  await expect(app.toast).toContainText('a seam came open');
  await expect(app.toast).toContainText('Your clips are still here');
  await app.button('Close').click();
  await page.evaluate(() => void Promise.reject(new Error('a promise was broken')));
  await expect(app.toast).toContainText('a promise was broken');
  await page.keyboard.press('Home');
  await page.keyboard.press('k');
  await expect.poll(() => app.frame()).toBeGreaterThan(0);
  expect(faults.length).toBeGreaterThan(0);
  faults.length = 0;
});

test('undo of the removal of the open clip: back at the frame and the loop it had', async ({
  app,
  page,
}) => {
  await app.openWith(...sampleFiles('walk-hik-30', 'walk-poser-30'));
  await app.row('walk-hik-30.bvh').getByRole('button').first().click();
  await page.keyboard.press('Home');
  for (const key of ['Shift+ArrowRight', '[', 'Shift+ArrowRight', 'Shift+ArrowRight', ']'])
    await page.keyboard.press(key);
  await app.expectFrame(9);
  await app.button('Remove walk-hik-30.bvh').click();
  await expect(app.openName).toHaveText('walk-poser-30.bvh');
  await app.expectFrame(0);
  await expect(page.locator('.loop-range')).toHaveCount(0);
  await page.keyboard.press('Control+z');
  await expect(app.openName).toHaveText('walk-hik-30.bvh');
  await app.expectFrame(9);
  await expect(page.locator('.loop-range')).toHaveText('0.10–0.30 s');
});

test('an archive with nothing to read says so and leaves the open clip', async ({ app }) => {
  await app.openWith(...sampleFiles('walk-hik-30'));
  const text = new TextEncoder().encode('no motion');
  const files = { 'nothing.zip': zipSync({ 'notes.txt': text, 'more/readme.md': text }) };
  await app.drop(...writeFiles(temporaryFolder(), files));
  await expect(app.toast).toContainText('nothing.zip: The archive holds no BVH files.');
  await expect(app.openName).toHaveText('walk-hik-30.bvh');
  await expect(app.rows).toHaveCount(1);
});
