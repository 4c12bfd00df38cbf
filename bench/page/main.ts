/** What the benchmark asks of the page, under `window.bench`. Times are milliseconds. */
import { loadCore } from '../../web/src/engine/raw';
import { type BitsFound, compareBits } from './bits';
import { type Extracted, extract } from './extraction';
import { bytesOf } from './files';
import { type LongestSteps, longestSteps } from './longest-steps';
import { type ManyClips, manyClips } from './many-clips';
import { type Opened, open } from './opening';
import { type PairFrames, pairFrames } from './pair';
import { poseAll, readByKeypose, readByThree } from './readers';
import { type StageFrames, drawFrames } from './stage';
import { readOnceByThree } from './three-once';
import { timeInTurn } from './timing';

const loading = loadCore();

/** A file of so many bytes takes three.js minutes: once is enough. */
const LONG_BYTES = 100e6;

export interface ReadingTimes {
  readonly keypose: number[];
  /** Read, and the position of every joint at every frame. */
  readonly keyposeAndPoses: number[];
  readonly three: number[];
  /** Whether three.js was ended before it was done. */
  readonly threeIsEnded: boolean;
}

/** Reads all files, one after the other, by each reader in turn. */
async function read(names: readonly string[], runs: number): Promise<ReadingTimes> {
  const core = await loading;
  const all = await bytesOf(names);
  const each = (work: (bytes: Uint8Array<ArrayBuffer>) => void) => () => all.forEach(work);
  const byKeypose = each((bytes) => readByKeypose(core, bytes).free());
  const withPoses = each((bytes) => poseAll(readByKeypose(core, bytes), bytes));
  const [long] = all.filter((bytes) => bytes.length > LONG_BYTES);
  if (long !== undefined) {
    const [keypose = [], keyposeAndPoses = []] = await timeInTurn([byKeypose, withPoses], runs);
    const { ms, isEnded } = await readOnceByThree(long);
    return { keypose, keyposeAndPoses, three: [ms], threeIsEnded: isEnded };
  }
  const byThree = each(readByThree);
  const times = await timeInTurn([byKeypose, withPoses, byThree], runs);
  const [keypose = [], keyposeAndPoses = [], three = []] = times;
  return { keypose, keyposeAndPoses, three, threeIsEnded: false };
}

/** Compares every value of the files with `Number` of its token. */
async function bits(names: readonly string[]): Promise<BitsFound> {
  const core = await loading;
  let [values, different] = [0, 0];
  for (const bytes of await bytesOf(names)) {
    const clip = readByKeypose(core, bytes);
    const found = compareBits(clip, new TextDecoder().decode(bytes));
    clip.free();
    values += found.values;
    different += found.different;
  }
  return { values, different };
}

/** Reads a file and extracts its keyposes, several times. */
async function extraction(name: string, runs: number): Promise<Extracted[]> {
  const core = await loading;
  const [bytes = new Uint8Array()] = await bytesOf([name]);
  const found: Extracted[] = [];
  for (let run = 0; run < runs; run += 1) {
    const clip = readByKeypose(core, bytes);
    found.push(extract(clip));
    clip.free();
    await new Promise((resolve) => setTimeout(resolve, 10));
  }
  return found;
}

export type { BitsFound, Extracted, LongestSteps, ManyClips, Opened, PairFrames, StageFrames };

const bench = { read, bits, extraction, open, drawFrames, longestSteps, manyClips, pairFrames };

declare global {
  interface Window {
    bench: typeof bench;
  }
}

window.bench = bench;
