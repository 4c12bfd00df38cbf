// A list of checks, one after the other. In: steps of a name and a command. Out: each step's time, and
// exit status 1 where one failed; the rest still run.
import { run } from './process.mjs';

/** Seconds since `start` (of performance.now()), for reading. */
export function secondsSince(start) {
  return `${((performance.now() - start) / 1000).toFixed(1)} s`;
}

function runStep({ name, command: [program, ...args] }) {
  console.log(`\n── ${name}`);
  const start = performance.now();
  let passed = true;
  try {
    run(program, args);
  } catch (error) {
    console.error(error.message);
    passed = false;
  }
  return { name, passed, time: secondsSince(start) };
}

/** Runs the steps `[{ name, command: [program, ...args] }]` and prints a table of their times. */
export function runSteps(steps) {
  const start = performance.now();
  const results = steps.map(runStep);
  console.log('');
  for (const { name, passed, time } of results) {
    console.log(`${passed ? 'passed' : 'FAILED'} ${time.padStart(9)}  ${name}`);
  }
  console.log(`       ${secondsSince(start).padStart(9)}  in all`);
  if (results.some(({ passed }) => !passed)) process.exitCode = 1;
}

/** The command that runs a program of node_modules with this Node, without npx. */
export function nodeProgram(path, ...args) {
  return [process.execPath, `node_modules/${path}`, ...args];
}

/** The keypose command that tests run; where `cargo test` ran, nothing is compiled again: profiles dev and test are one. */
export const commandStep = {
  name: 'keypose command',
  command: ['cargo', 'build', '--locked', '--quiet', '--bin', 'keypose'],
};
