// The Rust side of the set-up: the compiler, its wasm target, and wasm-pack with wasm-bindgen, which are
// built once per user from tools/ and kept in a cache folder. Out: the folder that holds them.
import { copyFileSync, existsSync, mkdirSync, readFileSync, renameSync, rmSync } from 'node:fs';
import { homedir } from 'node:os';
import { join } from 'node:path';
import { output, root, run } from './process.mjs';
import { hashOf } from './stamp.mjs';

const target = 'wasm32-unknown-unknown';
const programs = ['wasm-pack', 'wasm-bindgen'];
const extension = process.platform === 'win32' ? '.exe' : '';

/** Throws, saying what to do, where there is no Rust or one older than Cargo.toml asks for. */
export function requireRust() {
  const found = output('rustc', ['--version'])?.match(/(\d+)\.(\d+)/);
  if (!found || !output('cargo', ['--version'])) {
    throw new Error('Rust is missing: install it from https://rustup.rs, then run this again.');
  }
  const manifest = readFileSync(join(root, 'Cargo.toml'), 'utf8');
  const needed = manifest.match(/rust-version = "(\d+)\.(\d+)"/);
  if (compareVersions(found, needed) >= 0) return;
  throw new Error(
    `Rust ${found[0]} is too old: run "rustup update" for ${needed[1]}.${needed[2]}.`,
  );
}

function compareVersions([, major, minor], [, otherMajor, otherMinor]) {
  return major - otherMajor || minor - otherMinor;
}

/** Adds the wasm target through rustup where the compiler has none. */
export function ensureWasmTarget(say) {
  const sysroot = output('rustc', ['--print', 'sysroot']);
  if (existsSync(join(sysroot, 'lib', 'rustlib', target))) return;
  if (!output('rustup', ['--version'])) {
    throw new Error(
      `This Rust has no ${target} target and there is no rustup to add it: ` +
        'install Rust from https://rustup.rs, or the target from where your Rust came.',
    );
  }
  say(`adding Rust's ${target} target`);
  run('rustup', ['--quiet', 'target', 'add', target]);
}

function cacheFolder() {
  const base =
    process.env.XDG_CACHE_HOME ||
    (process.platform === 'win32' && process.env.LOCALAPPDATA) ||
    join(homedir(), '.cache');
  return join(
    base,
    'keypose',
    `tools-${hashOf(['tools/Cargo.toml', 'tools/Cargo.lock', 'tools/src'])}`,
  );
}

/** Builds wasm-pack and wasm-bindgen unless the cache has them. Returns their folder. */
export function ensureTools(say) {
  const folder = cacheFolder();
  const names = programs.map((name) => name + extension);
  if (names.every((name) => existsSync(join(folder, name)))) return folder;
  say('building wasm-pack and wasm-bindgen (once per user, about two minutes)');
  const built = join(root, 'tools', 'target');
  run('cargo', ['build', '--quiet', '--locked', '--target-dir', built], {
    cwd: join(root, 'tools'),
  });
  mkdirSync(folder, { recursive: true });
  for (const name of names) {
    // Renamed into place: another clone may be looking.
    const partial = join(folder, `${name}.${process.pid}`);
    copyFileSync(join(built, 'debug', name), partial);
    renameSync(partial, join(folder, name));
  }
  rmSync(built, { recursive: true });
  return folder;
}
