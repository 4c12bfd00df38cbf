// Playwright's `test` with the app on a watched page: a test fails where the page asks anything of another
// origin, breaks its own policy or tells of an error.
import { type Page, test as base, expect } from '@playwright/test';
import { isCommandBuilt } from '../../support/command';
import { AppPage } from './app-page';

export { expect };

interface AppFixtures {
  readonly app: AppPage;
  /** What the page did that it must not; a test that provokes it empties the list. */
  readonly faults: string[];
}

async function watch(page: Page, faults: string[]): Promise<void> {
  page.on('console', (message) => {
    if (message.type() === 'error') faults.push(`console: ${message.text()}`);
  });
  page.on('pageerror', (error) => faults.push(`error: ${error.message}`));
  page.on('crash', () => faults.push('the page crashed'));
  await page.context().route(isElsewhere, (route) => {
    faults.push(`request: ${route.request().url()}`);
    return route.abort();
  });
}

/** Everything that is served is served by this machine, to the tests alone. */
const isElsewhere = ({ protocol, hostname }: URL): boolean =>
  protocol.startsWith('http') && hostname !== '127.0.0.1';

export const test = base.extend<AppFixtures>({
  faults: async ({}, use) => use([]),
  app: async ({ page, faults }, use, info) => {
    info.skip(
      !isCommandBuilt(),
      'the keypose command, which makes the files to drop, is not built',
    );
    await watch(page, faults);
    await use(new AppPage(page));
    expect(faults).toEqual([]);
  },
});
