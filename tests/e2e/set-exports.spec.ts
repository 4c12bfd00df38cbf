/** What Compare takes away as a file, read again: the numbers of the command line, and pictures that show them. */
import { readFileSync } from 'node:fs';
import { dirname } from 'node:path';
import type { Page } from '@playwright/test';
import { runCommand } from '../support/command';
import { sampleBytes, temporaryFolder, writeFiles } from './support/motions';
import {
  clustersOf,
  clustersOfMerges,
  csvRows,
  pngSize,
  readNewick,
  readNpy,
} from './support/read-back';
import type { AppPage } from './support/app-page';
import { expect, test } from './support/test';

/** Names that every format has to write with care. */
const set: Readonly<Record<string, string>> = {
  'walk_"one", two.bvh': 'walk-hik-30',
  "walk_it's <b> & co.bvh": 'walk-poser-30',
  'walk_3.bvh': 'walk-vrm-30',
  'run_歩き.bvh': 'run-hik-30',
  'run_2.bvh': 'run-poser-30',
  'dance_1.bvh': 'slow-dance-hik-30',
};
const names = Object.keys(set);
const shortNames = names.map((name) => name.replace('.bvh', ''));

interface SetReport {
  readonly clips: readonly string[];
  readonly features: readonly (readonly number[])[];
  readonly condensed: readonly number[];
  readonly merges: readonly (readonly number[])[];
  readonly leaves: readonly number[];
  readonly map: readonly (readonly [number, number])[];
  readonly map_spread: number;
  readonly cluster_count: number;
  readonly evaluation: { readonly accuracy: number };
}

/** The files in the order in which the app has them, and what the command says of them. */
function given(): { paths: string[]; said: (...options: string[]) => string } {
  const contents = Object.entries(set).map(([name, id]) => [name, sampleBytes(id)] as const);
  const paths = writeFiles(temporaryFolder(), Object.fromEntries(contents));
  const said = (command = '', ...options: string[]): string =>
    runCommand([command, ...options, ...names], dirname(paths[0] ?? '')) ?? '';
  return { paths, said };
}

async function openCompare(app: AppPage, page: Page, paths: string[]): Promise<void> {
  await app.openWith(...paths);
  await page.locator('.page-tab', { hasText: 'Compare' }).click();
  await expect(page.locator('.matrix-name')).toHaveCount(names.length);
}

async function exported(page: Page, item: string): Promise<{ name: string; bytes: Uint8Array }> {
  await page
    .locator('.compare-bar')
    .getByRole('button', { name: /^Export/ })
    .click();
  const download = page.waitForEvent('download');
  await page.getByRole('menuitem', { name: item, exact: true }).click();
  const file = await download;
  return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
}

const textOf = (bytes: Uint8Array): string => new TextDecoder().decode(bytes);

/** The distance of two items, from SciPy's order of all pairs. */
function distance({ clips, condensed }: SetReport, a: number, b: number): number {
  const [i, j] = [Math.min(a, b), Math.max(a, b)];
  if (i === j) return 0;
  return condensed[i * clips.length - (i * (i + 1)) / 2 + j - i - 1] ?? NaN;
}

test('features, matrix, tree and scores: the same as the command line’s, and read again', async ({
  app,
  page,
}) => {
  const { paths, said } = given();
  const report = JSON.parse(said('compare', '--json', '--labels', '{label}_*')) as SetReport;
  await openCompare(app, page, paths);
  const square = names.flatMap((_, a) => names.map((_, b) => distance(report, a, b)));

  await test.step('features', async () => {
    const csv = await exported(page, 'Features (CSV)');
    expect(csv.name).toBe('features.csv');
    expect(textOf(csv.bytes)).toBe(said('features', '--csv'));
    const [head, ...rows] = csvRows(textOf(csv.bytes));
    expect(head?.slice(0, 2)).toEqual(['clip', 'mean_xx']);
    expect(rows.map(([clip]) => clip)).toEqual(names);
    expect(rows.map((row) => row.slice(1, 13).map(Number))).toEqual(report.features);
    const npy = await exported(page, 'Features (NumPy)');
    expect(npy.name).toBe('features.npy');
    const { shape, values } = readNpy(npy.bytes);
    expect(shape).toEqual([names.length, 12]);
    expect([...values]).toEqual(report.features.flat());
  });

  await test.step('matrix', async () => {
    const csv = await exported(page, 'Matrix (CSV)');
    const [head, ...rows] = csvRows(textOf(csv.bytes));
    expect(head).toEqual(['clip', ...names]);
    expect(rows.map(([clip]) => clip)).toEqual(names);
    expect(rows.flatMap((row) => row.slice(1).map(Number))).toEqual(square);
    const { shape, values } = readNpy((await exported(page, 'Matrix (NumPy)')).bytes);
    expect(shape).toEqual([names.length, names.length]);
    expect([...values]).toEqual(square);
  });

  await test.step('tree', async () => {
    const { name, bytes } = await exported(page, 'Tree (Newick)');
    expect(name).toBe('tree.nwk');
    expect(textOf(bytes)).toBe(said('compare', '--newick'));
    const found = clustersOf(readNewick(textOf(bytes)));
    const expected = clustersOfMerges(names, report.merges);
    const key = (members: readonly string[]): string => members.join('|');
    const heights = new Map(found.map((cluster) => [key(cluster.names), cluster.height]));
    expect([...heights.keys()].sort()).toEqual(expected.map((one) => key(one.names)).sort());
    for (const one of expected) expect(heights.get(key(one.names))).toBeCloseTo(one.height, 9);
  });

  await test.step('scores: none without labels, then those of the labels', async () => {
    await page
      .locator('.compare-bar')
      .getByRole('button', { name: /^Export/ })
      .click();
    const item = page.getByRole('menuitem', { name: /^Evaluation \(CSV\)/ });
    await expect(item).toContainText('the clips have no labels');
    await expect(item).toHaveAttribute('aria-disabled', 'true');
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Labels from file names…' }).click();
    await page.getByLabel('Pattern', { exact: true }).fill('{label}_*');
    await page.getByLabel('Pattern', { exact: true }).press('Enter');
    await expect(page.locator('.confusion')).toBeVisible();
    const csv = await exported(page, 'Evaluation (CSV)');
    expect(textOf(csv.bytes)).toBe(said('compare', '--csv', '--labels', '{label}_*'));
    const [head = [], ...rows] = csvRows(textOf(csv.bytes));
    const right = rows.filter((row) => row[head.indexOf('is_right')] === 'true').length;
    expect(right / rows.length).toBe(report.evaluation.accuracy);
    const json = JSON.parse(textOf((await exported(page, 'Evaluation (JSON)')).bytes)) as SetReport;
    expect(json.evaluation).toEqual(report.evaluation);
  });
});

interface Sheet {
  readonly width: number;
  readonly height: number;
  readonly title: string;
  readonly texts: readonly string[];
  /** Fills of the cells, row by row. */
  readonly cells: readonly string[];
  readonly paths: readonly { d: string; fill: string }[];
  /** What a picture must not hold: it would be run, or fetched. */
  readonly foreign: readonly string[];
}

/** The picture as a browser reads it; throws where it is not well-formed. */
async function sheetOf(page: Page, svg: string): Promise<Sheet> {
  return page.evaluate((text) => {
    const root = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
    if (root.querySelector('parsererror')) throw new Error(root.textContent);
    const number = (of: Element, name: string): number => Number(of.getAttribute(name));
    const all = (name: string): Element[] => [...root.querySelectorAll(name)];
    const known = ['svg', 'title', 'rect', 'path', 'line', 'text', 'g', 'image'];
    return {
      width: number(root, 'width'),
      height: number(root, 'height'),
      title: root.querySelector('title')?.textContent ?? '',
      texts: all('text').map(({ textContent }) => textContent ?? ''),
      cells: all('g[shape-rendering] rect').map((cell) => cell.getAttribute('fill') ?? ''),
      paths: all('path').map((path) => ({
        d: path.getAttribute('d') ?? '',
        fill: path.getAttribute('fill') ?? '',
      })),
      foreign: all('*')
        .map(({ localName }) => localName)
        .filter((name) => !known.includes(name)),
    };
  }, svg);
}

/** How many colours a PNG has, and which part of it is not as its first pixel. */
function inkOf(page: Page, bytes: Uint8Array): Promise<{ colours: number; part: number }> {
  return page.evaluate(
    async (data) => {
      const bitmap = await createImageBitmap(new Blob([new Uint8Array(data)]));
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = canvas.getContext('2d')!;
      context.drawImage(bitmap, 0, 0);
      const image = context.getImageData(0, 0, bitmap.width, bitmap.height);
      const pixels = new Uint32Array(image.data.buffer);
      const inked = pixels.reduce((count, pixel) => count + Number(pixel !== pixels[0]), 0);
      return { colours: new Set(pixels).size, part: inked / pixels.length };
    },
    [...bytes],
  );
}

/** Perceived, roughly: from 0, black, to 255. */
function lightness(fill: string): number {
  const parts = fill.startsWith('#')
    ? (fill.match(/[0-9a-f]{2}/gi) ?? []).map((byte) => parseInt(byte, 16))
    : (fill.match(/[\d.]+/g) ?? []).map(Number);
  const [red = 0, green = 0, blue = 0] = parts;
  return 0.3 * red + 0.59 * green + 0.11 * blue;
}

test('matrix, tree and map as SVG and PNG show the set', async ({ app, page }) => {
  const { paths, said } = given();
  const report = JSON.parse(said('compare', '--json')) as SetReport;
  await openCompare(app, page, paths);
  const legend = await page.locator('.legend-range').innerText();

  const svgAndPng = async (kind: string, least: number): Promise<Sheet> => {
    const svg = await exported(page, `${kind} (SVG)`);
    expect(svg.name).toBe(`${kind.toLowerCase()}.svg`);
    const sheet = await sheetOf(page, textOf(svg.bytes));
    expect(sheet.foreign).toEqual([]);
    expect(sheet.width).toBeGreaterThan(150);
    expect(sheet.height).toBeGreaterThan(100);
    const png = await exported(page, `${kind} (PNG)`);
    expect(png.name).toBe(`${kind.toLowerCase()}.png`);
    const size = { width: Math.floor(2 * sheet.width), height: Math.floor(2 * sheet.height) };
    expect(pngSize(png.bytes)).toEqual(size);
    const ink = await inkOf(page, png.bytes);
    expect(ink.colours).toBeGreaterThan(20);
    expect(ink.part).toBeGreaterThan(least);
    return sheet;
  };

  await test.step('matrix: every name, the legend, and cells as dark as their clips are alike', async () => {
    const sheet = await svgAndPng('Matrix', 0.1);
    expect(sheet.title).toBe('Matrix of distances');
    const ordered = report.leaves.map((item) => shortNames[item]);
    expect(sheet.texts.filter((text) => shortNames.includes(text))).toEqual(ordered);
    expect(sheet.texts.join()).toContain(legend);
    const { cells } = sheet;
    expect(cells).toHaveLength(names.length * (names.length - 1));
    const pairs = report.leaves.flatMap((a) =>
      report.leaves.filter((b) => b !== a).map((b) => distance(report, a, b)),
    );
    const shown = pairs.map((value, k) => ({ value, light: lightness(cells[k] ?? '') }));
    shown.sort((a, b) => a.value - b.value);
    const [first, last] = [shown[0]?.light ?? 0, shown.at(-1)?.light ?? 0];
    expect(Math.abs(first - last)).toBeGreaterThan(80);
    const sign = Math.sign(last - first);
    shown.slice(1).forEach(({ light }, k) => {
      expect(sign * (light - (shown[k]?.light ?? 0))).toBeGreaterThan(-1.5);
    });
  });

  await test.step('tree: every name in the order of the leaves', async () => {
    const sheet = await svgAndPng('Tree', 0.01);
    expect(sheet.texts).toEqual(report.leaves.map((item) => shortNames[item]));
  });

  await test.step('map: a disc for each clip, at its place', async () => {
    const sheet = await svgAndPng('Map', 0.005);
    expect(sheet.texts.join()).toContain(`${Math.round(100 * report.map_spread)} % of the spread`);
    const discs = sheet.paths.flatMap(({ d, fill }) => {
      const found = /^M([-\d.]+) ([-\d.]+)a([\d.]+) /.exec(d);
      return found ? [{ x: Number(found[1]) + Number(found[3]), y: Number(found[2]), fill }] : [];
    });
    // Each over its halo.
    expect(discs).toHaveLength(2 * names.length);
    const points = discs.filter((_, k) => k % 2 === 1);
    const ratios = names.flatMap((_, a) =>
      names.slice(0, a).map((_, b) => {
        const [p, q] = [points[a], points[b]];
        const [m, n] = [report.map[a], report.map[b]];
        return Math.hypot(p.x - q.x, p.y - q.y) / Math.hypot(m[0] - n[0], m[1] - n[1]);
      }),
    );
    const [least, most] = [Math.min(...ratios), Math.max(...ratios)];
    expect(least).toBeGreaterThan(10);
    expect(most / least).toBeLessThan(1.05);
  });
});
