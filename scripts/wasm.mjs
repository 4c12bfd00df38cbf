// The WebAssembly modules. In: the crates they are made of, wasm-pack's folder. Out: wasm, JavaScript and
// types of each in web/src/engine/generated/, made again only when something they come from changed.
import { existsSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { output, root, run } from './process.mjs';
import { hashOf, isStamped, stamp } from './stamp.mjs';

const generated = join(root, 'web', 'src', 'engine', 'generated');

/** Each module's own crate, then those that it is made of. */
const modules = [
  ['motion-wasm', 'motion', 'result-text', 'sample-motions'],
  ['comparison-wasm', 'comparison', 'result-text'],
];

function inputsHash(names) {
  const crates = names.flatMap((name) => [`crates/${name}/Cargo.toml`, `crates/${name}/src`]);
  const settings = ['Cargo.toml', 'Cargo.lock', '.cargo', 'tools/Cargo.lock', 'package-lock.json'];
  return hashOf([...crates, ...settings, 'scripts/wasm.mjs'], [output('rustc', ['--version'])]);
}

/** Builds the modules whose sources changed with the wasm-pack of `toolsFolder`. */
export function ensureWasm(toolsFolder, say) {
  for (const names of modules) {
    const [crate] = names;
    const stampFile = join(generated, `.stamp-${crate}`);
    const hash = inputsHash(names);
    if (isStamped(stampFile, hash)) continue;
    say(`building the WebAssembly module of ${crate}`);
    build(crate, toolsFolder);
    stamp(stampFile, hash);
  }
}

function build(crate, toolsFolder) {
  const bin = join(root, 'node_modules', '.bin');
  // wasm-pack skips the optimiser in silence where it does not find one.
  if (!existsSync(join(bin, 'wasm-opt'))) throw new Error('wasm-opt is missing from node_modules.');
  const options = ['--release', '--target', 'web', '--no-pack', '--mode', 'no-install'];
  const folders = [`crates/${crate}`, '--out-dir', generated];
  run(
    'wasm-pack',
    ['--log-level', 'warn', 'build', ...folders, ...options, '--', '--locked', '--quiet'],
    {
      env: { ...process.env, PATH: [toolsFolder, bin, process.env.PATH].join(delimiter) },
    },
  );
}
