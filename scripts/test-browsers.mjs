// `npm run test:browsers`: a walk through all pages in Firefox and in WebKitGTK, where they are installed.
// Out: each step's time; pictures in test-results/browsers.
import { nodeProgram, runSteps } from './steps.mjs';

const config = ['--config', 'vitest.browsers.config.ts'];

runSteps([
  {
    name: 'keypose command (release)',
    command: ['cargo', 'build', '--locked', '--quiet', '--release', '-p', 'keypose-cli'],
  },
  { name: 'Firefox and WebKit', command: nodeProgram('vitest/vitest.mjs', 'run', ...config) },
]);
