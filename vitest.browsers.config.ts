// The walk through all pages in browsers that no tool brings along: tests/browsers, where they are installed.
import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    include: ['tests/browsers/**/*.walk.ts'],
    environment: 'node',
    testTimeout: 300_000,
    hookTimeout: 120_000,
    fileParallelism: false,
    // Node 22 has it without being asked.
    execArgv: ['--experimental-websocket'],
    reporters: ['verbose'],
  },
});
