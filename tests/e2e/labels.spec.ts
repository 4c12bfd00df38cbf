/** Labels of a set: by file name with a preview, by folder, by hand in the table; the scores against them; keys alone. */
import type { Locator, Page } from '@playwright/test';
import type { AppPage } from './support/app-page';
import { sampleBytes, temporaryFolder, tinyBvh, writeFiles } from './support/motions';
import { expect, test } from './support/test';

/** Names as of a study: what is done, who, and which rig; one of a kind, and one that is no human. */
const set: Readonly<Record<string, string>> = {
  'gait/walk_anna.bvh': 'walk-hik-30',
  'gait/walk_ben.bvh': 'walk-poser-30',
  'gait/run_anna.bvh': 'run-hik-30',
  'gait/run_ben.bvh': 'run-poser-30',
  'dance/dance_anna.bvh': 'slow-dance-hik-30',
};
const compared = Object.keys(set).length;

async function openCompare(app: AppPage, page: Page): Promise<void> {
  const folder = temporaryFolder();
  const samples = Object.entries(set).map(([name, id]) => [name, sampleBytes(id)] as const);
  const files = { ...Object.fromEntries(samples), 'gait/chair.bvh': tinyBvh(40) };
  writeFiles(folder, files);
  await app.openWith(`${folder}/gait`, `${folder}/dance`);
  await page.locator('.page-tab', { hasText: 'Compare' }).click();
  await expect(page.locator('.compare.compared')).toBeVisible();
}

const scores = (page: Page): Locator => page.getByRole('region', { name: 'Against labels' });
const pattern = (page: Page): Locator => page.getByLabel('Pattern', { exact: true });
const menu = (page: Page, name: string): Locator =>
  page.locator('.compare-bar').getByRole('button', { name: new RegExp(`^${name}`) });

async function labelByName(page: Page, text: string): Promise<void> {
  await scores(page).getByRole('button', { name: 'Labels from file names…' }).click();
  await expect(pattern(page)).toBeFocused();
  await pattern(page).fill(text);
  await pattern(page).press('Enter');
  await expect(pattern(page)).toBeHidden();
}

test('a pattern of file names shows what it does, says what is wrong, and gives the scores', async ({
  app,
  page,
}) => {
  await openCompare(app, page);
  await expect(scores(page)).toContainText('Label the clips to see');
  await menu(page, 'Labels').click();
  await page.getByRole('menuitemradio', { name: 'from file name…' }).click();
  await expect(pattern(page)).toBeFocused();
  const dialog = page.getByRole('dialog', { name: 'Labels from file names' });
  await expect(dialog).toContainText('5 of 6 names match. 3 different labels.');
  await expect(dialog).toContainText('1 clip stays without a label');
  const found = dialog.locator('.label-examples td:last-child');
  await expect(found).toHaveText(['run', 'walk', 'dance', 'no label']);
  await pattern(page).fill('{label}*');
  await expect(dialog.getByRole('alert')).toContainText('Something must stand between');
  await expect(dialog.getByRole('button', { name: 'Label', exact: true })).toBeDisabled();
  await pattern(page).fill('{label}_*');
  await pattern(page).press('Enter');
  await expect(dialog).toBeHidden();
  await expect(menu(page, 'Labels')).toHaveText('from file name');
  await expect(scores(page)).toContainText(/\d+\.\d %\s*\d of 5/);
  await expect(scores(page)).toContainText('dance_anna is the only dance: it cannot be found.');
  const confusion = page.getByRole('table', { name: 'Label, and label of its nearest' });
  await expect(confusion.getByRole('rowheader')).toHaveText([/run/, /walk/, /dance/]);
});

test('of many labels a part is drawn, and all are reached', async ({ app, page }) => {
  const walk = sampleBytes('walk-hik-30');
  const folder = temporaryFolder();
  const many = Array.from({ length: 40 }, (_, n) => [`m${n}_walk.bvh`, walk] as const);
  writeFiles(folder, Object.fromEntries(many));
  await app.openWith(folder);
  await page.locator('.page-tab', { hasText: 'Compare' }).click();
  await expect(page.locator('.compare.compared')).toBeVisible();
  await labelByName(page, '{label}_*');
  const confusion = page.getByRole('table', { name: 'Label, and label of its nearest' });
  await expect(confusion).toHaveAttribute('aria-rowcount', '41');
  await expect(confusion.getByRole('rowheader').first()).toHaveText(/m0/);
  expect(await confusion.getByRole('rowheader').count()).toBeLessThan(15);
  expect(await confusion.getByRole('cell').count()).toBeLessThan(400);
  await page.locator('.confusion-scroll').evaluate((scroll) => {
    scroll.scrollTo(scroll.scrollWidth, scroll.scrollHeight);
  });
  await expect(confusion.getByRole('rowheader').last()).toHaveText(/m39/);
  await expect(confusion.getByRole('columnheader').last()).toHaveText(/m39/);
  await expect(confusion.getByRole('columnheader').last()).toBeInViewport({ ratio: 1 });
  await expect(confusion.getByRole('rowheader').last()).toBeInViewport({ ratio: 1 });
  const errors = page.locator('.evaluation-errors');
  await expect(errors.getByRole('heading')).toHaveText('40 errors');
  expect(await errors.getByRole('listitem').count()).toBeLessThan(30);
  await errors.evaluate((scroll) => scroll.scrollTo(0, scroll.scrollHeight));
  await expect(errors.getByRole('listitem').last()).toHaveAttribute('aria-posinset', '40');
  await expect(errors.getByRole('listitem').last()).toBeInViewport({ ratio: 1 });
  const legend = page.getByRole('list', { name: 'Labels' });
  const others = legend.getByRole('listitem').last();
  await expect(others).toHaveText('… and 28 more');
  await expect(others).toBeInViewport({ ratio: 1 });
  const beyond = await scores(page).evaluate((one) => one.scrollWidth - one.clientWidth);
  expect(beyond).toBeLessThanOrEqual(0);
});

test('an error is reached by a press: it becomes the pair', async ({ app, page }) => {
  await openCompare(app, page);
  await labelByName(page, '{label}_*');
  const error = scores(page).getByRole('button', { name: /^dance_anna/ });
  await error.click();
  await expect(error).toHaveAttribute('aria-pressed', 'true');
  await expect(app.row('dance_anna.bvh')).toHaveClass(/open/);
  await expect(page.locator('.pair-name').first()).toContainText('dance_anna');
  await expect(page.locator('.distance-sentence')).toContainText(/differ|further|same/);
  await expect(page.getByRole('button', { name: 'Open pair' })).toBeEnabled();
  // Everything of the why stands between the margins of its panel.
  const [panel, body] = await Promise.all(
    ['#compare-side', '.why-body .painted-body'].map((part) => page.locator(part).boundingBox()),
  );
  expect(body!.x + body!.width).toBeLessThanOrEqual(panel!.x + panel!.width - 16);
});

test('labels go into the library, its rows and its filter, and beside the open clip’s name', async ({
  app,
  page,
}) => {
  await openCompare(app, page);
  await labelByName(page, '*_{label}');
  await expect(app.row('walk_ben.bvh')).toContainText('Label: ben');
  await app.field('Filter by name or label').fill('ben');
  await expect(app.rows).toHaveCount(2);
  await app.row('walk_ben.bvh').locator('.clip-open').click();
  await page.locator('.page-tab', { hasText: 'Study' }).click();
  await expect(page.locator('.top-label')).toHaveText('ben');
});

test('by folder; undo takes it back', async ({ app, page }) => {
  await openCompare(app, page);
  await menu(page, 'Labels').click();
  await page.getByRole('menuitemradio', { name: 'from folder' }).click();
  await expect(scores(page)).toContainText(/of 5/);
  await page.keyboard.press('Control+z');
  await expect(scores(page)).toContainText('Label the clips to see');
});

test('by hand in the table, with keys alone; undone together', async ({ app, page }) => {
  await openCompare(app, page);
  await page.getByRole('tab', { name: 'Why' }).focus();
  await page.keyboard.press('End');
  await expect(page.getByRole('tab', { name: 'Table' })).toBeFocused();
  const row = (name: string): Locator =>
    page
      .getByRole('row')
      .filter({ has: page.locator(`.table-name > .clip-name[title="${name}"]`) });
  const name = (of: string): Locator => row(of).locator('.table-name');
  await expect(row('chair')).toContainText('not');
  await name('run_anna').focus();
  await page.keyboard.press('Space');
  await page.keyboard.press('ArrowDown');
  await expect(name('run_ben')).toBeFocused();
  await page.keyboard.press('Space');
  await page.getByLabel('Label 2 clips').fill('running');
  await page.keyboard.press('Enter');
  await expect(app.row('run_ben.bvh')).toContainText('Label: running');
  await expect(scores(page)).toContainText(`${compared - 2} clips have no label`);
  await name('walk_ben').focus();
  await page.keyboard.press('F2');
  await page.keyboard.type('walking');
  await page.keyboard.press('Enter');
  await expect(app.row('walk_ben.bvh')).toContainText('Label: walking');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await expect(page.locator('.clip-label')).toHaveCount(0);
});

test('the table is sorted, filtered, grouped, and chooses the pair', async ({ app, page }) => {
  await openCompare(app, page);
  await labelByName(page, '{label}_*');
  await page.getByRole('tab', { name: 'Table' }).click();
  const table = page.getByRole('grid', { name: 'All clips' });
  const names = table.locator('.table-name .clip-name');
  const titles = (): Promise<(string | null)[]> =>
    names.evaluateAll((all) => all.map((one) => one.getAttribute('title')));
  await table.getByRole('button', { name: 'Name' }).click();
  await expect(table.getByRole('columnheader', { name: 'Name' })).toHaveAttribute(
    'aria-sort',
    'descending',
  );
  await expect
    .poll(titles)
    .toEqual(['walk_ben', 'walk_anna', 'run_ben', 'run_anna', 'dance_anna', 'chair']);
  await page.getByRole('button', { name: 'Group by label' }).click();
  await expect(table.locator('.group-title').last()).toHaveText(/Not compared\s*1/);
  await page.locator('.table-tools input').fill('run');
  await expect(names).toHaveCount(2);
  await names.nth(0).click();
  await names.nth(1).click({ modifiers: ['Shift'] });
  await expect(table.locator('tr[aria-selected="true"]')).toHaveCount(2);
  await page.getByRole('button', { name: 'Open pair' }).click();
  await expect(
    page.locator('.page-tab[aria-current="page"], .page-tab[aria-current="true"]'),
  ).toHaveText('Pair');
});

test('mirrors leave Ward out and say why', async ({ app, page }) => {
  await openCompare(app, page);
  await menu(page, 'Distance').click();
  await page.getByRole('menuitemcheckbox', { name: 'Mirror-aware' }).click();
  await page.keyboard.press('Escape');
  await expect(menu(page, 'Tree')).toHaveText('Group average');
  await menu(page, 'Tree').click();
  const ward = page.getByRole('menuitemradio', { name: /Ward/ });
  await expect(ward).toHaveAttribute('aria-disabled', 'true');
  await expect(ward).toContainText('needs a distance without mirrors');
  await ward.click({ force: true });
  await expect(menu(page, 'Tree')).toHaveText('Group average');
});

test('the scores are exported and read again', async ({ app, page }) => {
  await openCompare(app, page);
  await labelByName(page, '{label}_*');
  await menu(page, 'Export').click();
  const download = page.waitForEvent('download');
  await page.getByRole('menuitem', { name: 'Evaluation (JSON)' }).click();
  const stream = await (await download).createReadStream();
  const text = (await stream.toArray()).join('');
  const { evaluation } = JSON.parse(text) as { evaluation: { accuracy: number; f: number } };
  const percent = (100 * evaluation.accuracy).toFixed(1);
  await expect(scores(page)).toContainText(`${percent} %`);
  await expect(scores(page)).toContainText(evaluation.f.toFixed(2));
});

test('the neighbours are gone through by keys', async ({ app, page }) => {
  await openCompare(app, page);
  await page.getByRole('tab', { name: 'Neighbours' }).click();
  await expect(page.locator('.side-panel')).toContainText('This clip is not compared.');
  await app.row('walk_anna.bvh').locator('.clip-open').click();
  const rows = page.locator('.neighbour');
  await expect(rows).toHaveCount(compared - 1);
  await rows.first().focus();
  await page.keyboard.press('Enter');
  await expect(rows.first()).toHaveAttribute('aria-pressed', 'true');
  await page.keyboard.press('ArrowDown');
  await expect(rows.nth(1)).toBeFocused();
  await expect(rows.nth(1)).toHaveAttribute('aria-pressed', 'true');
});

const groups = (page: Page): Locator => page.locator('.library-rows .group');
const head = (page: Page, name: string): Locator =>
  page.locator('.library').getByRole('button', { name, exact: true });

test('the library stands in groups by label, folded by press and by keys', async ({
  app,
  page,
}) => {
  await openCompare(app, page);
  await expect(groups(page)).toHaveCount(0);
  await labelByName(page, '{label}_*');
  await expect(groups(page)).toHaveText([/run\s*2/, /walk\s*2/, /dance\s*1/, /No label\s*1/]);
  await expect(app.rows).toHaveCount(6);
  await head(page, 'walk').click();
  await expect(head(page, 'walk')).toHaveAttribute('aria-expanded', 'false');
  await expect(app.rows).toHaveCount(4);
  await expect(app.row('walk_anna.bvh')).toHaveCount(0);
  await head(page, 'walk').press('ArrowRight');
  await expect(app.rows).toHaveCount(6);
  // Down from the head: the first of its clips opens; up again: the head has the focus.
  await head(page, 'walk').press('ArrowDown');
  await expect(app.row('walk_anna.bvh')).toHaveClass(/open/);
  await expect(app.row('walk_anna.bvh').locator('.clip-open')).toBeFocused();
  await page.keyboard.press('ArrowUp');
  await expect(head(page, 'walk')).toBeFocused();
  await page.keyboard.press('ArrowUp');
  await expect(app.row('run_ben.bvh').locator('.clip-open')).toBeFocused();
  await expect(app.row('run_ben.bvh')).toHaveClass(/open/);
  await app.button('Sort').click();
  await page.getByRole('menuitemcheckbox', { name: 'Group by label' }).click();
  await page.keyboard.press('Escape');
  await expect(groups(page)).toHaveCount(0);
});

test('a label is renamed for all its clips, with keys alone, and undone', async ({ app, page }) => {
  await openCompare(app, page);
  await labelByName(page, '{label}_*');
  await head(page, 'walk').focus();
  await page.keyboard.press('F2');
  const field = page.getByLabel('New name of walk');
  await expect(field).toBeFocused();
  await field.press('Control+a');
  await page.keyboard.type('gait');
  await page.keyboard.press('Enter');
  await expect(head(page, 'gait')).toBeFocused();
  await expect(groups(page)).toHaveText([/run/, /gait\s*2/, /dance/, /No label/]);
  await expect(
    page.getByRole('table', { name: 'Label, and label of its nearest' }).getByRole('rowheader'),
  ).toHaveText([/run/, /gait/, /dance/]);
  await page.keyboard.press('F2');
  await page.keyboard.type('never');
  await page.keyboard.press('Escape');
  await expect(head(page, 'gait')).toBeFocused();
  await page.keyboard.press('Control+z');
  await expect(groups(page)).toHaveText([/run/, /walk\s*2/, /dance/, /No label/]);
  // By the button, onto a name that there is: both become one.
  await head(page, 'walk').hover();
  await app.button('Rename the label walk').click();
  await page.getByLabel('New name of walk').fill('run');
  await page.keyboard.press('Enter');
  await expect(groups(page)).toHaveText([/run\s*4/, /dance/, /No label/]);
});

test('several clips are chosen together, labelled and removed, and each undone at once', async ({
  app,
  page,
}) => {
  await openCompare(app, page);
  const open = (name: string): Locator => app.row(name).locator('.clip-open');
  await open('run_anna.bvh').click();
  await open('walk_anna.bvh').click({ modifiers: ['ControlOrMeta'] });
  const status = page.locator('.library-ticked [role="status"]');
  await expect(status).toHaveText('2 selected');
  // What can be done with them stands inside the library.
  const edges = await page
    .locator('.library-ticked, .library-ticked button')
    .evaluateAll((parts) => parts.map((part) => part.getBoundingClientRect().right));
  const library = (await page.locator('#library').boundingBox())!;
  expect(Math.max(...edges)).toBeLessThanOrEqual(library.x + library.width);
  await open('walk_anna.bvh').press('Shift+ArrowDown');
  await expect(status).toHaveText('2 selected');
  await expect(app.row('walk_ben.bvh')).toHaveClass(/ticked/);
  await page.getByLabel('Label of the selected clips').fill('gait');
  await page.keyboard.press('Enter');
  await expect(groups(page)).toHaveText([/gait\s*2/, /No label\s*4/]);
  await open('walk_ben.bvh').focus();
  await page.keyboard.press('Delete');
  await expect(app.toast).toHaveText('2 clips removed');
  await expect(app.rows).toHaveCount(4);
  await expect(page.locator('.library-ticked')).toHaveCount(0);
  await page.keyboard.press('Control+z');
  await expect(app.rows).toHaveCount(6);
  await app.rows.first().locator('.clip-open').focus();
  await page.keyboard.press('Control+a');
  await expect(status).toHaveText('6 selected');
  // The table ticks the same clips.
  await page.getByRole('tab', { name: 'Table' }).click();
  await expect(page.getByRole('checkbox', { name: 'Tick all' })).toBeChecked();
  await app.rows.first().locator('.clip-open').focus();
  await page.keyboard.press('Escape');
  await expect(page.locator('.library-ticked')).toHaveCount(0);
});
