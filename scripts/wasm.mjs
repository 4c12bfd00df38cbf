// The WebAssembly module. In: the crates it is made of, wasm-pack's folder. Out: wasm, JavaScript and
// types in web/src/engine/generated/, made again only when something they come from changed.
import { existsSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { output, root, run } from './process.mjs';
import { hashOf, isStamped, stamp } from './stamp.mjs';

const generated = join(root, 'web', 'src', 'engine', 'generated');
const stampFile = join(generated, '.stamp');

function inputsHash() {
  const crates = ['motion', 'motion-wasm', 'sample-motions'].flatMap((name) => [
    `crates/${name}/Cargo.toml`,
    `crates/${name}/src`,
  ]);
  const settings = ['Cargo.toml', 'Cargo.lock', '.cargo', 'tools/Cargo.lock', 'package-lock.json'];
  return hashOf([...crates, ...settings, 'scripts/wasm.mjs'], [output('rustc', ['--version'])]);
}

/** Builds the module with the wasm-pack of `toolsFolder` where its sources changed. */
export function ensureWasm(toolsFolder, say) {
  const hash = inputsHash();
  if (isStamped(stampFile, hash)) return;
  const bin = join(root, 'node_modules', '.bin');
  // wasm-pack skips the optimiser in silence where it does not find one.
  if (!existsSync(join(bin, 'wasm-opt'))) throw new Error('wasm-opt is missing from node_modules.');
  say('building the WebAssembly module');
  const options = ['--release', '--target', 'web', '--no-pack', '--mode', 'no-install'];
  const folders = ['crates/motion-wasm', '--out-dir', generated];
  run(
    'wasm-pack',
    ['--log-level', 'warn', 'build', ...folders, ...options, '--', '--locked', '--quiet'],
    {
      env: { ...process.env, PATH: [toolsFolder, bin, process.env.PATH].join(delimiter) },
    },
  );
  stamp(stampFile, hash);
}
