// The page by itself: it opens, keeps its own policy, and asks nothing of anyone else.
import { expect, test } from '@playwright/test';

test('the page opens without an error and without a request beyond its origin', async ({
  page,
  baseURL,
}) => {
  const faults: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'error') faults.push(message.text());
  });
  page.on('pageerror', (error) => faults.push(error.message));
  page.on('request', (request) => {
    const { protocol, origin } = new URL(request.url());
    if (protocol.startsWith('http') && origin !== baseURL) faults.push(request.url());
  });
  await page.goto('/', { waitUntil: 'networkidle' });
  await expect(page).toHaveTitle(/Keypose/);
  expect(faults).toEqual([]);
});
