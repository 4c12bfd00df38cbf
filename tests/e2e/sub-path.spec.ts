// The built app below a path of a host that is nothing but a folder of files.
import { join } from 'node:path';
import { expect, test } from '@playwright/test';
import { serveFolder } from '../support/static-server';

const dist = join(import.meta.dirname, '..', '..', 'dist');

test('a sample is analysed and drawn below any path', async ({ page }) => {
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
    expect(missing).toEqual([]);
  } finally {
    await host.stop();
  }
});
