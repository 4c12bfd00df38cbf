/** A set that changes while it is looked at: clips come and go, decisions are taken, files and workers fail. */
import { readFileSync } from 'node:fs';
import { basename, dirname } from 'node:path';
import type { Locator, Page } from '@playwright/test';
import { runCommand } from '../support/command';
import type { AppPage } from './support/app-page';
import {
  sampleBytes,
  sampleFiles,
  sampleText,
  temporaryFolder,
  tinyBvh,
  withShortRow,
  withTwoPerformers,
  writeFiles,
} from './support/motions';
import { csvRows } from './support/read-back';
import { reportOf } from './support/reports';
import { expect, test } from './support/test';

const showPage = (page: Page, name: string): Promise<void> =>
  page.locator('.page-tab', { hasText: name }).click();
const currentPage = (page: Page): Locator => page.locator('.page-tab[aria-current="page"]');
const names = (page: Page): Locator => page.locator('.matrix-name');
const clipButton = (page: Page, which: 'a' | 'b'): Locator =>
  page.locator(`[popovertarget="pair-clip-${which}"]`);

/** By the keyboard, once the library is shown. */
async function remove(app: AppPage, name: string): Promise<void> {
  await expect(app.row(name)).toBeVisible();
  await app.row(name).locator('.clip-open').press('Delete');
}

async function openCompare(app: AppPage, page: Page, count: number, ...paths: string[]) {
  await app.openWith(...paths);
  await showPage(page, 'Compare');
  await expect(names(page)).toHaveCount(count);
}

test('files dropped onto Compare and onto Pair join the set, and the page stays', async ({
  app,
  page,
}) => {
  await openCompare(app, page, 2, ...sampleFiles('walk-hik-30', 'run-hik-30'));
  await app.drop(...sampleFiles('slow-dance-hik-30', 'walk-poser-30'));
  await expect(names(page)).toHaveCount(4);
  await expect(currentPage(page)).toHaveText('Compare');
  await expect(app.openName).toHaveCount(0);
  await showPage(page, 'Pair');
  await expect(clipButton(page, 'b')).not.toContainText('Choose');
  const [a, b] = await Promise.all(
    (['a', 'b'] as const).map((which) => clipButton(page, which).innerText()),
  );
  await app.drop(...sampleFiles('run-poser-30'));
  await clipButton(page, 'b').click();
  await expect(page.locator('#pair-clip-b .pair-list-row')).toHaveCount(5);
  await page.keyboard.press('Escape');
  await expect(currentPage(page)).toHaveText('Pair');
  expect(await clipButton(page, 'a').innerText()).toBe(a);
  expect(await clipButton(page, 'b').innerText()).toBe(b);
  await showPage(page, 'Compare');
  await expect(names(page)).toHaveCount(5);
});

test('A and B of a pair are removed and brought back, on Compare as on Pair', async ({
  app,
  page,
}) => {
  const ids = ['walk-hik-30', 'walk-poser-30', 'run-hik-30'];
  await openCompare(app, page, 3, ...sampleFiles(...ids));
  const at = (name: string): Locator => page.locator(`.matrix-name[title="${name}"]`);
  await at('walk-hik-30').click();
  await at('run-hik-30').click({ modifiers: ['Shift'] });
  await showPage(page, 'Pair');
  await expect(clipButton(page, 'a')).toContainText('walk-hik-30');
  await expect(clipButton(page, 'b')).toContainText('run-hik-30');

  // The library is not shown on Pair: a clip goes by way of Compare, or comes back by undo.
  await showPage(page, 'Compare');
  await remove(app, 'run-hik-30.bvh');
  await expect(names(page)).toHaveCount(2);
  await expect(page.getByRole('option', { selected: true })).toHaveCount(1);
  await showPage(page, 'Pair');
  await expect(clipButton(page, 'b')).toContainText('walk-poser-30');
  await page.keyboard.press('Control+z');
  await expect(page.locator('.pair-rows')).toBeVisible();
  await expect(clipButton(page, 'a')).toContainText('walk-hik-30');
  await page.keyboard.press('Control+Shift+Z');
  await expect(clipButton(page, 'b')).toContainText('walk-poser-30');

  await showPage(page, 'Compare');
  await remove(app, 'walk-hik-30.bvh');
  await expect(page.locator('.compare-message')).toContainText('drop another');
  await showPage(page, 'Pair');
  await expect(page.locator('.stage-sentence:visible').last()).toContainText(
    'Choose a second clip',
  );
  await page.keyboard.press('Control+z');
  await expect(page.locator('.pair-rows')).toBeVisible();
  await showPage(page, 'Compare');
  await expect(names(page)).toHaveCount(2);

  for (const name of ['walk-hik-30.bvh', 'walk-poser-30.bvh']) {
    await remove(app, name);
  }
  await expect(
    page.getByRole('heading', {
      name: 'See the keyposes of a motion, and which motions are alike.',
    }),
  ).toBeVisible();
  for (let n = 0; n < 3; n++) await page.keyboard.press('Control+z');
  await expect(names(page)).toHaveCount(3);
});

/** The rows of the features, as Compare exports them: of each clip 12 numbers. */
async function features(page: Page): Promise<ReadonlyMap<string, readonly number[]>> {
  await page
    .locator('.compare-bar')
    .getByRole('button', { name: /^Export/ })
    .click();
  const download = page.waitForEvent('download');
  await page.getByRole('menuitem', { name: 'Features (CSV)' }).click();
  const [, ...rows] = csvRows(readFileSync(await (await download).path(), 'utf8'));
  return new Map(rows.map(([clip = '', ...values]) => [clip, values.slice(0, 12).map(Number)]));
}

/** The same by the command line. */
function featureOf(path: string, ...options: string[]): readonly number[] {
  const text = runCommand(['features', ...options, basename(path)], dirname(path)) ?? '';
  return (csvRows(text)[1] ?? []).slice(1, 13).map(Number);
}

test('a decision about a clip is compared too: leading frames, a joint, the up axis; undo as well', async ({
  app,
  page,
}) => {
  const [walk = '', run = ''] = sampleFiles('walk-hik-30', 'run-hik-30');
  const [usual, other] = [featureOf(walk), featureOf(run)];
  await app.openWith(walk, run);
  await app.row('walk-hik-30.bvh').locator('.clip-open').click();

  const expectFeature = async (expected: readonly number[]): Promise<void> => {
    await showPage(page, 'Compare');
    await expect.poll(async () => [...(await features(page)).values()]).toEqual([expected, other]);
    await showPage(page, 'Study');
  };
  await expectFeature(usual);
  await app.tab('Doctor');
  await app.field('Leading frames left out').fill('20');
  await app.field('Leading frames left out').blur();
  await app.settled();
  const later = featureOf(walk, '--leading-rest-frames', '20');
  expect(later).not.toEqual(usual);
  await expectFeature(later);
  await page.keyboard.press('Control+z');
  await app.settled();
  await expectFeature(usual);

  await app.tab('Body');
  const finger = app.field('Left finger');
  const [wrist = ''] = reportOf(walk).body.joints.flatMap(({ role, joint }) =>
    role === 'left_wrist' ? [joint] : [],
  );
  await finger.focus();
  await finger.selectOption({ label: wrist });
  await app.field('Up axis').selectOption('+Z');
  await app.settled();
  const decided = featureOf(walk, '--joint', `left_finger=${wrist}`, '--up=+Z');
  expect(decided).not.toEqual(usual);
  await expectFeature(decided);
});

test('what cannot be read or compared is a row with its reason; the others are compared', async ({
  app,
  page,
}) => {
  const { text, line } = withShortRow('walk-hik-30');
  const files = writeFiles(temporaryFolder(), {
    'walk.bvh': sampleBytes('walk-hik-30'),
    'two.bvh': withTwoPerformers('run-hik-30'),
    'run.bvh': sampleBytes('run-hik-30'),
    'short.bvh': text,
    'empty.bvh': '',
    // Good until its last row.
    'late.bvh': sampleText('run-poser-30').replace(/\S+\s*$/, 'x\n'),
    'prop.bvh': tinyBvh(50),
    'pose.bvh': tinyBvh(1),
    'still.bvh': sampleText('walk-hik-30').replace(
      /Frames:.*\n(.*\n)(.*\n)[^]*/,
      'Frames: 1\n$1$2',
    ),
  });
  await openCompare(app, page, 3, ...files);
  await expect(app.toast).toHaveText('3 of 9 files could not be read');
  // Of two performers the first is compared: the runner, as alone.
  const found = await features(page);
  expect([...found.keys()]).toEqual(['walk.bvh', 'two.bvh', 'run.bvh']);
  expect(found.get('two.bvh')).toEqual(found.get('run.bvh'));
  await page.getByRole('tab', { name: 'Table' }).click();
  const row = (name: string): Locator =>
    page.getByRole('row').filter({ has: page.locator(`.clip-name[title="${name}"]`) });
  await expect(row('short')).toContainText(`line ${line}`);
  await expect(row('empty')).toContainText('The file is empty');
  await expect(row('late')).toContainText(/line \d{3}/);
  await expect(row('prop')).toContainText(/human/);
  await expect(row('pose')).toContainText(/human|frame/);
  await expect(row('still')).toContainText(/frame/);
  await expect(page.getByRole('button', { name: '3 clips stand apart' })).toBeVisible();

  // As A one that is not compared, as B one that could not be read: told, and nothing breaks.
  await app.row('prop.bvh').locator('.clip-open').click();
  await row('walk')
    .locator('.table-name')
    .click({ modifiers: ['Shift'] });
  await page.getByRole('tab', { name: 'Why' }).click();
  await expect(page.locator('.side-panel')).toContainText('These two are not compared.');
  await page.getByRole('button', { name: 'Open pair' }).click();
  await expect(page.locator('.pair-side')).toContainText('These two cannot be compared.');
  await page.keyboard.press('End');
  await expect(page.locator('.pair-clock .clock-time').first()).not.toHaveText('0.00');
});

/** Ends the worker of the comparison as a bug in it would. */
async function killComparison(page: Page): Promise<void> {
  const worker = page.workers().find((one) => one.url().includes('comparison'));
  expect(worker).toBeDefined();
  await worker?.evaluate(
    () =>
      void setTimeout(() => {
        throw new Error('it breaks');
      }),
  );
}

test('the worker of the comparison dies, at rest and at work: another takes over', async ({
  app,
  page,
  faults,
}) => {
  const ids = ['walk-hik-30', 'walk-poser-30', 'run-hik-30', 'run-poser-30', 'slow-dance-hik-30'];
  await openCompare(app, page, ids.length, ...sampleFiles(...ids));
  const cut = page.getByRole('slider', { name: 'Cut of the tree' });
  await killComparison(page);
  await cut.focus();
  await page.keyboard.press('End');
  await expect(cut).toHaveAttribute('aria-valuetext', '5 clusters');

  await page.getByRole('button', { name: /^Distance/ }).click();
  await killComparison(page);
  await page.getByRole('menuitemcheckbox', { name: 'Across rigs' }).click();
  await page.keyboard.press('Escape');
  await app.drop(...sampleFiles('slow-dance-poser-30'));
  await expect(names(page)).toHaveCount(ids.length + 1);
  await page.keyboard.press('Home');
  await expect(cut).toHaveAttribute('aria-valuemax', '6');
  await cut.focus();
  await page.keyboard.press('End');
  await expect(cut).toHaveAttribute('aria-valuetext', '6 clusters');
  await expect(page.locator('#compare')).not.toHaveClass(/comparing/);
  expect(faults.filter((fault) => !fault.includes('it breaks'))).toEqual([]);
  faults.length = 0;
});
