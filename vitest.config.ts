// The TypeScript unit tests, which need no browser: beside their source, and the parity tests in Node.
import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    include: ['web/src/**/*.test.ts', 'tests/**/*.test.ts'],
    environment: 'node',
    setupFiles: ['web/src/app/i18n/test-words.ts'],
    maxWorkers: 2,
  },
});
