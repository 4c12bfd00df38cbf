// `npm run test:browsers`: a walk through all pages in Firefox and in WebKitGTK, where they are installed.
// Out: each step's time; pictures in test-results/browsers.
import { commandStep, nodeProgram, runSteps } from './steps.mjs';

const config = ['--config', 'vitest.browsers.config.ts'];

runSteps([
  commandStep,
  { name: 'Firefox and WebKit', command: nodeProgram('vitest/vitest.mjs', 'run', ...config) },
]);
