// `npm run test:long`: what takes too long for every change: an hour of motion, thousands of clips, many
// more random files. Out: each step's time.
import { commandStep, nodeProgram, runSteps } from './steps.mjs';

process.env.PROPTEST_CASES ??= '50000';

runSteps([
  commandStep,
  {
    name: 'Rust properties, 50 000 cases each',
    command: ['cargo', 'test', '--locked', '--quiet', '-p', 'motion', '--test', 'bvh_properties'],
  },
  {
    name: 'long browser tests',
    command: nodeProgram(
      '@playwright/test/cli.js',
      'test',
      '--config',
      'playwright.long.config.ts',
    ),
  },
]);
