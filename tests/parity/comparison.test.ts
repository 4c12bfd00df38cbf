/** A set compared by the command line and by the WebAssembly module in Node is the same, to the last bit. */
import { readFile } from 'node:fs/promises';
import { expect, it } from 'vitest';
import { loadComparisonCore } from '../../web/src/engine/comparison-raw';
import type {
  ClipFeature,
  ComparisonExportKind,
  ComparisonSettings,
} from '../../web/src/engine/comparison-types';
import type { Core } from '../../web/src/engine/raw';
import { testCore } from '../../web/src/engine/test-engine';
import { runCommand } from '../support/command';
import { type MotionFile, parityMotions } from './motions';

const wasmFile = new URL('../../web/src/engine/generated/comparison_wasm_bg.wasm', import.meta.url);

/** The feature of a motion, from a survey as the app makes it. */
function featureOf(core: Core, { bytes }: MotionFile): ClipFeature | null {
  const clip = core.newClip();
  try {
    clip.beginReading(bytes.length);
    clip.push(bytes);
    clip.endReading();
    clip.beginAnalysis({}, {});
    while (clip.stepSurvey() < 1);
    return clip.survey().performers.find(({ comparable }) => comparable)?.comparable ?? null;
  } finally {
    clip.free();
  }
}

/** The label that the pattern `{label}-*` finds in a name. */
const labelOf = (name: string): string | null => /^(.+?)-.*/.exec(name)?.[1] ?? null;

const sets: readonly { readonly settings: ComparisonSettings; readonly options: string[] }[] = [
  {
    settings: {
      distance: { measure: 'posture-variation', mirrorAware: false, acrossRigs: false },
      linkage: 'ward',
    },
    options: [],
  },
  {
    settings: {
      distance: { measure: 'posture-variation', mirrorAware: true, acrossRigs: true },
      linkage: 'average',
    },
    options: ['--mirror', '--across-rigs'],
  },
];

const files: readonly { readonly kind: ComparisonExportKind; readonly command: string[] }[] = [
  { kind: 'tree-newick', command: ['compare', '--newick'] },
  { kind: 'evaluation-csv', command: ['compare', '--csv', '--labels', '{label}-*'] },
];

it('gives the files of the command line', async ({ skip }) => {
  const core = await testCore();
  const motions = parityMotions(core);
  const paths = motions.map(({ path }) => path);
  const comparing = await loadComparisonCore(new Uint8Array(await readFile(wasmFile)));
  const set = comparing.newSet();
  const compared = motions.filter((motion, id) => {
    const feature = featureOf(core, motion);
    if (feature !== null) set.setFeature(id, motion.name, feature);
    return feature !== null;
  });
  const labels = compared.map(({ name }) => labelOf(name));
  for (const { settings, options } of sets) {
    set.begin(settings, false);
    while (set.step() < 1);
    const clusters = set.comparison(settings).automaticClusters;
    const textOf = (kind: ComparisonExportKind): Promise<string> => {
      const file = set.file(kind, { clusters, labels });
      while (file.step() < 1);
      const blob = file.take();
      file.free();
      return blob.text();
    };
    for (const { kind, command } of files) {
      const expected = runCommand([...command, ...options, ...paths]);
      if (expected === null) return skip();
      // The texts are too long to be shown where they differ.
      const isSame = (await textOf(kind)) === expected;
      expect(isSame, `${kind} ${options.join(' ')}`).toBe(true);
    }
    const across = options.filter((option) => option === '--across-rigs');
    const features = runCommand(['features', '--csv', ...across, ...paths]);
    expect((await textOf('features-csv')) === features).toBe(true);
    expectScores(await textOf('evaluation-json'), [...options, ...paths]);
    expectMatrix(await textOf('matrix-csv'), [...options, ...paths]);
  }
  set.free();
}, 240_000);

/** The evaluation, letter by letter, stands in the object of the command. */
function expectScores(text: string, args: readonly string[]): void {
  const whole = runCommand(['compare', '--json', '--labels', '{label}-*', ...args]) ?? '';
  for (const member of ['version', 'parameters', 'clips', 'labels', 'clusters', 'evaluation']) {
    const [found, expected] = [text, whole].map((json) =>
      JSON.stringify((JSON.parse(json) as Record<string, unknown>)[member]),
    );
    expect(found, member).toBe(expected);
  }
}

/** The matrix holds the condensed distances of the command. */
function expectMatrix(table: string, args: readonly string[]): void {
  const whole = runCommand(['compare', '--json', ...args]) ?? '{}';
  const { condensed } = JSON.parse(whole) as { readonly condensed: readonly number[] };
  const rows = table.trimEnd().split('\r\n').slice(1);
  const upper = rows.flatMap((row, item) => row.split(',').slice(item + 2));
  expect(upper.map(Number)).toEqual(condensed);
}
