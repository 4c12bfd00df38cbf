// The motions that parity is tested on: the clips with reference values, where the test data is there, and
// all samples. Out: each with its name and bytes, as files for the command line.
import { mkdtempSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Core } from '../../web/src/engine/raw';
import { dataFolder } from '../support/data';
import { writeSamples } from './native';

export interface MotionFile {
  readonly name: string;
  readonly path: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
}

function fileAt(path: string, name: string): MotionFile {
  return { name, path, bytes: new Uint8Array(readFileSync(path)) };
}

function goldenClips(): MotionFile[] {
  const folder = dataFolder();
  if (folder === null) return [];
  const names = readdirSync(join(folder, 'golden')).filter((name) => name.endsWith('.json'));
  return names.sort().map((json) => {
    const name = json.replace('.json', '.bvh');
    return fileAt(join(folder, 'cmu', name), name);
  });
}

function samples(core: Core): MotionFile[] {
  const folder = mkdtempSync(join(tmpdir(), 'keypose-parity-'));
  writeSamples(folder);
  for (const { id, fileName } of core.samples) {
    writeFileSync(join(folder, fileName), core.sample(id) ?? '');
  }
  const names = readdirSync(folder).filter((name) => name.endsWith('.bvh'));
  return names.sort().map((name) => fileAt(join(folder, name), name));
}

/** The samples offered by the core, all samples that the command writes, and the clips. */
export function parityMotions(core: Core): MotionFile[] {
  return [...samples(core), ...goldenClips()];
}
