// The tests that take long: tests/long, one after the other, in Chromium and beside it.
import { defineConfig } from '@playwright/test';
import { chromiumArguments, findChromium } from './scripts/chromium.mjs';

export default defineConfig({
  testDir: 'tests/long',
  testMatch: '**/*.long.ts',
  outputDir: 'test-results',
  workers: 1,
  timeout: 600_000,
  expect: { timeout: 60_000 },
  reporter: [['list']],
  use: { launchOptions: { executablePath: findChromium(), args: chromiumArguments } },
});
