// The browser tests: tests/e2e and tests/parity, in Chromium, against the built app.
import { createHash } from 'node:crypto';
import { defineConfig } from '@playwright/test';
import {
  chromiumArguments,
  findChromium,
  findHeadlessShell,
  flatArguments,
} from './scripts/chromium.mjs';

/** KEYPOSE_PORT, or a port of this folder's own, so that several clones can be tested at once. */
function port(): number {
  if (process.env.KEYPOSE_PORT) return Number(process.env.KEYPOSE_PORT);
  const hash = createHash('sha256')
    .update(import.meta.dirname)
    .digest();
  return 20_000 + (hash.readUInt32LE() % 20_000);
}

/** Tests that look at the stage; the others run quicker in a browser without WebGL. */
const drawn = /(stage|page|film|appearance)\.spec\.ts/;

const address = `http://127.0.0.1:${port()}`;
const vite = `"${process.execPath}" node_modules/vite/bin/vite.js`;

export default defineConfig({
  testDir: 'tests',
  testMatch: '**/*.spec.ts',
  outputDir: 'test-results',
  fullyParallel: true,
  forbidOnly: !!process.env.CI,
  // A machine may stall; whoever works on a test is told of every failure, and the report of all that was tried again.
  retries: process.env.CI ? 1 : 0,
  workers: 2,
  // Two slow cores, shared: generous, since nothing waits longer than it has to.
  timeout: 120_000,
  expect: { timeout: 30_000 },
  reporter: [['list']],
  use: {
    baseURL: address,
    viewport: { width: 1440, height: 900 },
    locale: 'en-GB',
    colorScheme: 'light',
    actionTimeout: 30_000,
    // Without its film, which costs as much as the tests.
    trace: { mode: 'retain-on-failure', screenshots: false },
  },
  projects: [
    {
      name: 'drawn',
      testMatch: drawn,
      use: { launchOptions: { executablePath: findChromium(), args: chromiumArguments } },
    },
    {
      name: 'flat',
      testIgnore: drawn,
      use: { launchOptions: { executablePath: findHeadlessShell(), args: flatArguments } },
    },
  ],
  webServer: {
    command: `${vite} build --logLevel warn && ${vite} preview --host 127.0.0.1 --port ${port()} --strictPort`,
    url: address,
    timeout: 120_000,
  },
});
