/** A set from the first file to the last export without a pointer, and what ears are told on the way. */
import { readFileSync } from 'node:fs';
import { reach } from './support/by-keys';
import { sampleBytes, temporaryFolder, writeFiles } from './support/motions';
import { expect, test } from './support/test';

const set: Readonly<Record<string, string>> = {
  'walk_anna.bvh': 'walk-hik-30',
  'walk_ben.bvh': 'walk-poser-30',
  'run_anna.bvh': 'run-hik-30',
  'run_ben.bvh': 'run-poser-30',
  'dance_anna.bvh': 'slow-dance-hik-30',
  'dance_ben.bvh': 'slow-dance-poser-30',
};

const givenPaths = (): string[] =>
  writeFiles(
    temporaryFolder(),
    Object.fromEntries(Object.entries(set).map(([name, id]) => [name, sampleBytes(id)])),
  );

test('pick files, compare, cut, select, open the pair, warp, label, read the scores, export: all by keys', async ({
  app,
  page,
}) => {
  test.setTimeout(120_000);
  await app.open();
  const press = async (...keys: string[]): Promise<void> => {
    for (const key of keys) await page.keyboard.press(key);
  };

  await test.step('the files, by the browser’s own dialog', async () => {
    await reach(page, app.button('Choose files'));
    const choosing = page.waitForEvent('filechooser');
    await press('Enter');
    await (await choosing).setFiles(givenPaths());
    await app.settled();
  });

  const tab = (name: string) => page.locator('.page-tab', { hasText: name });
  await test.step('to Compare, and the cut of the tree', async () => {
    await reach(page, tab('Compare'));
    await press('Enter');
    const cut = page.getByRole('slider', { name: 'Cut of the tree' });
    await reach(page, cut);
    await press('End');
    await expect(cut).toHaveAttribute('aria-valuetext', '6 clusters');
    await press('Home', 'ArrowRight', 'ArrowRight');
    await expect(cut).toHaveAttribute('aria-valuetext', '3 clusters');
  });

  const cell = page.getByRole('gridcell');
  await test.step('a pair of the matrix, selected in every view', async () => {
    await reach(page, cell, 'Shift+Tab', page.locator('.matrix-ring.hovered'));
    await press('Control+Home', 'ArrowRight', 'ArrowRight', ' ');
    await expect(cell).toHaveAttribute('aria-colindex', '4');
    const column = (await page.getByRole('columnheader').first().textContent()) ?? '';
    const row = (await page.getByRole('rowheader').first().textContent()) ?? '';
    await expect(cell).toHaveAttribute(
      'aria-label',
      new RegExp(`^${row} with ${column}, 0\\.\\d+, \\d+(st|nd|rd|th) of 15 pairs$`),
    );
    const chosen = page.getByRole('option', { selected: true });
    await expect(chosen).toHaveCount(2);
    await expect(page.locator('.clip.open .clip-name')).toHaveAttribute('title', `${row}.bvh`);
    await expect(page.locator('.pair-name')).toHaveText([new RegExp(row), new RegExp(column)]);
    await press('Enter');
    await expect(page.locator('#pair')).toBeVisible();
    await expect(page.locator('[popovertarget="pair-clip-a"]')).toContainText(row);
    await expect(page.locator('[popovertarget="pair-clip-b"]')).toContainText(column);
  });

  await test.step('both on one clock: from the start, warped, mirrored', async () => {
    await reach(page, app.button('Start'));
    await press('Enter');
    await reach(page, app.button('Time warp'));
    await press('Enter');
    await expect(app.button('Time warp')).toHaveAttribute('aria-pressed', 'true');
    await expect(page.locator('.pair-difference')).toBeVisible();
    await press('Home', 'k');
    await expect(page.locator('.pair-slider')).toHaveAttribute(
      'aria-valuetext',
      /^[1-9]*\d\.\d\d seconds of A, \d+\.\d\d seconds of B$/,
    );
    await reach(page, app.button('Mirror B'));
    await press(' ');
    await expect(app.button('Mirror B')).toHaveAttribute('aria-pressed', 'true');
  });

  const menu = (name: string) =>
    page.locator('.compare-bar').getByRole('button', { name: new RegExp(`^${name}`) });
  await test.step('labels by a pattern of the names', async () => {
    await reach(page, tab('Compare'), 'Shift+Tab');
    await press('Enter');
    await reach(page, menu('Labels'));
    await press('Enter');
    await expect(page.getByRole('menuitemradio', { name: 'none' })).toBeFocused();
    await press('ArrowUp', 'Enter');
    await expect(page.getByLabel('Pattern', { exact: true })).toBeFocused();
    await press('Control+a');
    await page.keyboard.type('{label}_*');
    await press('Enter');
  });

  await test.step('the scores, read', async () => {
    const scores = page.getByRole('region', { name: 'Against labels' });
    await expect(scores).toContainText(/\d+\.\d %\s*[0-6] of 6/);
    const confusion = scores.getByRole('table', { name: 'Label, and label of its nearest' });
    await expect(confusion.getByRole('rowheader')).toHaveCount(3);
    await expect(confusion.getByRole('columnheader')).toHaveCount(3);
  });

  await test.step('a file', async () => {
    await reach(page, menu('Export'), 'Shift+Tab');
    await press('Enter');
    await expect(page.getByRole('menuitem', { name: 'Features (CSV)' })).toBeFocused();
    for (let n = 0; n < 6; n++) await press('ArrowDown');
    const download = page.waitForEvent('download');
    await press('Enter');
    const file = await download;
    expect(file.suggestedFilename()).toBe('evaluation.json');
    const { labels, clusters } = JSON.parse(readFileSync(await file.path(), 'utf8')) as {
      labels: string[];
      clusters: number[];
    };
    expect(labels).toEqual(['walk', 'walk', 'run', 'run', 'dance', 'dance']);
    expect(new Set(clusters).size).toBe(3);
  });

  await test.step('and all of it back by undo', async () => {
    await press('Control+z');
    await expect(page.locator('.evaluation')).toContainText('Label the clips to see');
  });
});

test('for ears: a grid with headers, a tree with its cut, a map of named places, and the table of all', async ({
  app,
  page,
}) => {
  await app.openWith(...givenPaths());
  await page.locator('.page-tab', { hasText: 'Compare' }).click();
  await expect(page.locator('.matrix-name')).toHaveCount(6);
  const grid = page.getByRole('grid', { name: 'Matrix of distances' });
  await expect(grid).toHaveAttribute('aria-rowcount', '7');
  await expect(grid).toHaveAttribute('aria-colcount', '7');
  await page.getByRole('gridcell').focus();
  await page.keyboard.press('Control+End');
  await expect(grid).toMatchAriaSnapshot(`
    - grid "Matrix of distances":
      - row:
        - columnheader
      - row:
        - rowheader
        - gridcell /.+ with itself/
  `);
  await expect(grid.getByRole('row').nth(1)).toHaveAttribute('aria-rowindex', '7');
  await expect(grid.getByRole('columnheader')).toHaveAttribute('aria-colindex', '7');

  const tree = page.getByRole('group', { name: 'Tree of the clips' });
  await expect(tree.getByRole('slider', { name: 'Cut of the tree' })).toHaveAttribute(
    'aria-valuetext',
    /^\d clusters?$/,
  );
  const names = page.getByRole('listbox', { name: 'Clips in the order of the matrix' });
  await expect(names.getByRole('option')).toHaveCount(6);

  // Every place of the map is reached, and says who it is.
  const map = page.getByRole('group', { name: 'Map of the clips: near is alike' });
  await map.getByRole('button').focus();
  const told = new Set<string>();
  for (const key of [
    'Left',
    'Up',
    'Right',
    'Down',
    'Right',
    'Up',
    'Left',
    'Down',
    'Down',
    'Right',
  ]) {
    await page.keyboard.press(`Arrow${key}`);
    told.add((await map.getByRole('button').getAttribute('aria-label')) ?? '');
  }
  expect(told.size).toBeGreaterThan(2);
  for (const one of told)
    expect(one).toMatch(/^(walk|run|dance)_(anna|ben), no label, cluster \d$/);

  // What the map and the matrix show is in the table, in words.
  await page.getByRole('tab', { name: 'Table' }).click();
  const table = page.getByRole('grid', { name: 'All clips' });
  await expect(table.getByRole('columnheader')).toContainText([
    'Name',
    'Cluster',
    'Nearest',
    'Distance',
  ]);
  await expect(table.getByRole('row')).toHaveCount(7);
  await expect(table.getByRole('row').nth(1)).toContainText(/(walk|run|dance)_(anna|ben)/);
});
