// `npm run check`: format, lint and types. Out: each step's time.
import { nodeProgram, runSteps } from './steps.mjs';

const clippy = ['cargo', 'clippy', '--locked', '--quiet'];
const denyWarnings = ['--', '-D', 'warnings'];
const modules = ['-p', 'motion-wasm', '-p', 'comparison-wasm'];
const wasm = [...modules, '--target', 'wasm32-unknown-unknown'];
const eslint = ['eslint/bin/eslint.js', '--max-warnings', '0', '.'];

runSteps([
  { name: 'Rust format', command: ['cargo', 'fmt', '--all', '--check'] },
  { name: 'clippy', command: [...clippy, '--workspace', '--all-targets', ...denyWarnings] },
  { name: 'clippy for WebAssembly', command: [...clippy, ...wasm, ...denyWarnings] },
  {
    name: 'TypeScript and script format',
    command: nodeProgram('prettier/bin/prettier.cjs', '--check', '--log-level', 'warn', '.'),
  },
  { name: 'types', command: nodeProgram('typescript/bin/tsc', '--noEmit') },
  { name: 'ESLint', command: nodeProgram(...eslint) },
]);
