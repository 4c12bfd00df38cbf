// `npm test`: that the numbers are right and the page does what it says. Out: each step's time.
import { commandStep, nodeProgram, runSteps } from './steps.mjs';

runSteps([
  { name: 'Rust tests', command: ['cargo', 'test', '--locked', '--quiet', '--no-fail-fast'] },
  commandStep,
  { name: 'TypeScript unit tests', command: nodeProgram('vitest/vitest.mjs', 'run') },
  { name: 'browser tests', command: nodeProgram('@playwright/test/cli.js', 'test') },
]);
