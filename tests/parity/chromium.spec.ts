/** The WebAssembly modules in Chromium say what the command line says, to the last bit. */
import { type Page, expect, test } from '@playwright/test';
import { createComparer } from '../../web/src/engine/comparer';
import { createEngine } from '../../web/src/engine/engine';
import {
  spawnAround,
  spawnComparisonAround,
  testComparisonCore,
  testCore,
} from '../../web/src/engine/test-engine';
import { runCommand } from '../support/command';
import { type EnginePage, serveEnginePage } from '../support/engine-page';
import { type Compared, comparedBy } from '../support/engine-page/compared';
import { type MotionFile, parityMotions } from './motions';
import { nativeReports, withoutName } from './native';

let served: EnginePage;

test.beforeAll(async () => {
  served = await serveEnginePage();
});

test.afterAll(() => served.close());

/** The page, from which every motion can be fetched by its name. */
async function openWith(page: Page, motions: readonly MotionFile[]): Promise<void> {
  const paths = new Map(motions.map(({ name, path }) => [name, path]));
  await page.route('**/motions/*', (route) => {
    const name = decodeURIComponent(new URL(route.request().url()).pathname.split('/').pop() ?? '');
    return route.fulfill({ path: paths.get(name) ?? '' });
  });
  await page.goto(served.address);
}

test('Chromium gives the reports of the command line', async ({ page }) => {
  test.setTimeout(180_000);
  const motions = parityMotions(await testCore());
  const native = nativeReports(motions);
  test.skip(native === null, 'the keypose command is not built');
  await openWith(page, motions);
  for (const [id, { name }] of motions.entries()) {
    const line = await page.evaluate(
      async ([clip, file]) => {
        const blob = await (await fetch(`motions/${encodeURIComponent(file)}`)).blob();
        await window.engine.open(clip, { name: file, folder: '', blob }, {}, {});
        const text = await window.engine.exportText(clip, 'keyposes-json');
        window.engine.close(clip);
        return text;
      },
      [id, name] as const,
    );
    expect(withoutName(line), name).toBe(native?.[id]);
  }
});

/** What real workers in Chromium say of the set. */
async function comparedInChromium(page: Page, motions: readonly MotionFile[]): Promise<Compared> {
  await openWith(page, motions);
  return page.evaluate(
    async (names) => {
      const sourceOf = async (name: string) => {
        const blob = await (await fetch(`motions/${encodeURIComponent(name)}`)).blob();
        return { name, folder: '', blob };
      };
      const sources = await Promise.all(names.map(sourceOf));
      return window.comparedBy(window.engine, window.comparer, sources);
    },
    motions.map(({ name }) => name),
  );
}

async function comparedInNode(motions: readonly MotionFile[]): Promise<Compared> {
  const engine = createEngine({ spawn: spawnAround(await testCore()), workers: 1 });
  const comparer = createComparer(engine, spawnComparisonAround(await testComparisonCore()));
  const sources = motions.map(({ name, bytes }) => ({ name, folder: '', blob: new Blob([bytes]) }));
  const compared = await comparedBy(engine, comparer, sources);
  comparer.destroy();
  engine.destroy();
  return compared;
}

test('a set compared in Chromium is that of the command line, and all of it that of Node', async ({
  page,
}) => {
  test.setTimeout(180_000);
  const motions = parityMotions(await testCore());
  const paths = motions.map(({ path }) => path);
  const newick = runCommand(['compare', '--newick', ...paths]);
  test.skip(newick === null, 'the keypose command is not built');
  const inChromium = await comparedInChromium(page, motions);
  // The texts are too long to be shown where they differ.
  const expectSame = (found: string | undefined, expected: string | null, what: string): void =>
    expect(found === expected, what).toBe(true);

  const [plain, across] = inChromium.sets;
  const options = ['--mirror', '--across-rigs'];
  expectSame(plain?.files['tree-newick'], newick, 'the tree');
  expectSame(
    across?.files['tree-newick'],
    runCommand(['compare', '--newick', ...options, ...paths]),
    'the tree across rigs',
  );
  expectSame(
    plain?.files['features-csv'],
    runCommand(['features', '--csv', ...paths]),
    'the features',
  );
  const inNode = await comparedInNode(motions);
  inNode.sets.forEach((said, index) => {
    const found = inChromium.sets[index];
    for (const [kind, text] of Object.entries(said.files))
      expectSame(found?.files[kind as keyof typeof said.files], text, `${index} ${kind}`);
    expectSame(found?.found, said.found, `${index} tree, map, picture, neighbours, scores`);
  });
  expectSame(inChromium.warpings, inNode.warpings, 'warpings');
});
