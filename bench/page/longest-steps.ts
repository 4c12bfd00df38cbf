/**
 * Comparing in steps: a number of clips goes in; how long the longest step of each thing that the comparison's
 * worker does took, on which a cancel has to wait, comes out.
 */
import { usualSettings } from '../../web/src/app/compare-store';
import {
  type CoreSet,
  type CoreWork,
  loadComparisonCore,
} from '../../web/src/engine/comparison-raw';
import type {
  ComparisonExportKind,
  ComparisonSettings,
  LabelledCut,
} from '../../web/src/engine/comparison-types';
import { heapedFeatures } from './heaps';

export interface LongestSteps {
  readonly clips: number;
  /** From the first step to the comparison. */
  readonly comparedMs: number;
  /** Bytes of the WebAssembly memory once it is compared. */
  readonly memoryBytes: number;
  /** Milliseconds of the longest step, by what is done. */
  readonly longestMs: Readonly<Record<string, number>>;
}

/** Steps of a file that are looked at: its rows are alike. */
const STEPS_OF_A_FILE = 200;

const average: ComparisonSettings = { ...usualSettings, linkage: 'average' };
const settingsOf = {
  Ward: usualSettings,
  'group average': average,
  'mirror-aware': { ...average, distance: { ...average.distance, mirrorAware: true } },
} satisfies Record<string, ComparisonSettings>;
const files: readonly ComparisonExportKind[] = ['matrix-csv', 'matrix-npy', 'evaluation-json'];

function msOf(work: () => void): number {
  const start = performance.now();
  work();
  return performance.now() - start;
}

/** The longest of the beginning, of every step and of the end. */
function longestOf<T>(begin: () => CoreWork<T>, most = Number.POSITIVE_INFINITY): number {
  const start = performance.now();
  const work = begin();
  let longest = performance.now() - start;
  let done = 0;
  for (let count = 0; done < 1 && count < most; count += 1) {
    const ms = msOf(() => (done = work.step()));
    longest = Math.max(longest, ms);
  }
  if (done >= 1)
    longest = Math.max(
      longest,
      msOf(() => work.take()),
    );
  work.free();
  return longest;
}

function compared(set: CoreSet, settings: ComparisonSettings): CoreWork<Int32Array> {
  set.begin(settings, false);
  return {
    step: () => set.step(),
    take: () => set.comparison(settings).tree.leaves,
    free: () => undefined,
  };
}

function askedOf(set: CoreSet, order: Int32Array, labelled: LabelledCut): Record<string, number> {
  const [first = 0, second = 0] = order;
  const whole = { order, firstRow: 0, firstColumn: 0, most: 1_024 };
  const region = { ...whole, rowCount: order.length, columnCount: order.length };
  return {
    picture: longestOf(() => set.picture(region)),
    why: longestOf(() => set.explain(first, second)),
    neighbours: msOf(() => set.neighbours(first, 100)),
    cut: msOf(() => set.cut(labelled.clusters)),
    scores: longestOf(() => set.evaluate(labelled)),
    files: Math.max(
      ...files.map((kind) => longestOf(() => set.file(kind, labelled), STEPS_OF_A_FILE)),
    ),
  };
}

export async function longestSteps(
  count: number,
  by: keyof typeof settingsOf,
): Promise<LongestSteps> {
  const features = heapedFeatures(count);
  const core = await loadComparisonCore();
  const set = core.newSet();
  features.forEach(({ feature }, id) => set.setFeature(id, `clip-${id}.bvh`, feature));
  const settings = settingsOf[by];
  let comparing = 0;
  const comparedMs = msOf(() => (comparing = longestOf(() => compared(set, settings))));
  const memoryBytes = core.memoryBytes();
  // Half of the clips have no label: where one of them is the nearest, all are looked at.
  const labels = features.map(({ heap }, id) => (id % 2 === 0 ? `heap ${heap}` : null));
  const { leaves } = set.comparison(settings).tree;
  const asked = askedOf(set, leaves, { clusters: 60, labels });
  return { clips: count, comparedMs, memoryBytes, longestMs: { comparing, ...asked } };
}
