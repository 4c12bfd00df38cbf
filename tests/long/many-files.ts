// Thousands of files that take no room: names for the samples at 30 frames per second, over and over.
// In: a folder. Out: the paths, and after how many the motions begin again.
import { linkSync, mkdirSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { writeSamples } from '../parity/native';

export const MANY = 3_000;

/** `into/clips/KIND_0001.bvh`, KIND being walk, run, slow or tired. */
export function writeMany(into: string): { paths: string[]; period: number } {
  writeSamples(join(into, 'samples'));
  const samples = readdirSync(join(into, 'samples')).filter((name) => name.endsWith('-30.bvh'));
  const clips = join(into, 'clips');
  mkdirSync(clips);
  const paths = Array.from({ length: MANY }, (_, index) => {
    const sample = samples[index % samples.length] ?? '';
    const name = `${sample.split('-')[0]}_${String(index).padStart(4, '0')}.bvh`;
    linkSync(join(into, 'samples', sample), join(clips, name));
    return join(clips, name);
  });
  return { paths, period: samples.length };
}
