// Everything a fresh clone lacks, step by step; each is skipped when it is done already.
// In: a machine with Node and Rust; `--browser` for a Chromium too, `--fonts` for the pictures' faces.
// Out: node_modules, the wasm target, wasm-pack, the WebAssembly module; one line per step taken.
// Node built-ins only until `npm ci` ran.
import { join } from 'node:path';
import { ensureFonts } from './fonts.mjs';
import { root, run } from './process.mjs';
import { ensureTools, ensureWasmTarget, requireRust } from './rust.mjs';
import { hashOf, isStamped, stamp } from './stamp.mjs';
import { ensureWasm } from './wasm.mjs';

const started = performance.now();

function say(step) {
  const seconds = ((performance.now() - started) / 1000).toFixed(1);
  console.log(`set-up ${seconds.padStart(6)} s  ${step}`);
}

function ensurePackages() {
  const stampFile = join(root, 'node_modules', '.keypose-stamp');
  const hash = hashOf(['package-lock.json']);
  if (isStamped(stampFile, hash)) return;
  say('installing the packages (npm ci)');
  run('npm', ['ci', '--no-audit', '--no-fund', '--loglevel=error']);
  stamp(stampFile, hash);
}

function requireNode() {
  const [major, minor] = process.versions.node.split('.').map(Number);
  if (major > 20 || (major === 20 && minor >= 19)) return;
  throw new Error(`Node ${process.versions.node} is too old: 20.19 or newer is needed.`);
}

try {
  requireNode();
  requireRust();
  ensurePackages();
  ensureWasmTarget(say);
  ensureWasm(ensureTools(say), say);
  if (process.argv.includes('--browser')) (await import('./chromium.mjs')).ensureChromium(say);
  if (process.argv.includes('--fonts')) ensureFonts(say);
  say('ready');
} catch (error) {
  console.error(`set-up: ${error.message}`);
  process.exitCode = 1;
}
