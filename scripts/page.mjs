// The built app in a browser, for scripts. In: options of the browser's context, and what to do with a page
// of it. Out: what that gives; server and browser are closed whatever happens.
import { chromium } from '@playwright/test';
import { preview } from 'vite';
import { chromiumArguments, findChromium } from './chromium.mjs';

/** Serves dist/ and calls `use(page, address)` with a page that is still blank. */
export async function withPage(contextOptions, use) {
  const server = await preview({ preview: { port: 0, host: '127.0.0.1' } });
  const browser = await chromium.launch({
    executablePath: findChromium(),
    args: chromiumArguments,
  });
  try {
    const context = await browser.newContext(contextOptions);
    return await use(
      await context.newPage(),
      `http://127.0.0.1:${server.httpServer.address().port}/`,
    );
  } finally {
    await browser.close();
    await server.close();
  }
}
