/** What is dropped or picked becomes rows of the library, whatever lies around it. */
import { linkSync } from 'node:fs';
import { join } from 'node:path';
import { zipSync } from 'fflate';
import {
  longText,
  sampleBytes,
  sampleFiles,
  temporaryFolder,
  tinyBvh,
  withShortRow,
  writeFiles,
} from './support/motions';
import { expect, test } from './support/test';

test('one file: it opens by itself, with its length, rate and keyposes', async ({ app, page }) => {
  await app.openWith(...sampleFiles('walk-hik-30'));
  await app.expectNames('walk-hik-30.bvh');
  await expect(app.openName).toHaveText('walk-hik-30.bvh');
  await expect(page).toHaveTitle('walk-hik-30.bvh · Keypose');
  await expect(app.row('walk-hik-30.bvh')).toContainText(/\d\.\d s · 30 Hz/);
  await expect(app.row('walk-hik-30.bvh')).toContainText('10 keyposes');
  await expect(app.caption).toContainText('Keypose 1 of 10');
  await expect(page.locator('.library-count')).toHaveText('1 clip');
});

test('three files: three rows in the order given, the first one open', async ({ app, page }) => {
  const ids = ['slow-dance-vrm-30', 'walk-hik-60', 'walk-poser-30'];
  await app.openWith(...sampleFiles(...ids));
  await app.expectNames(...ids.map((id) => `${id}.bvh`));
  await expect(page.locator('.clip.ready')).toHaveCount(3);
  await expect(page.locator('.clip .thumbnail > *').first()).toBeAttached();
  await expect(page.locator('.top-place')).toHaveText(/^[123] \/ 3$/);
  await app.row('walk-poser-30.bvh').getByRole('button').first().click();
  await expect(app.openName).toHaveText('walk-poser-30.bvh');
  await app.button('Previous clip').click();
  await expect(app.openName).toHaveText('walk-hik-60.bvh');
});

test('a folder: every motion at any depth, more than a hundred, and nothing else', async ({
  app,
  page,
}) => {
  const folder = temporaryFolder();
  const many = Array.from({ length: 130 }, (_, n) => `dances/many/m${n}.bvh`);
  writeFiles(folder, {
    'dances/walk.bvh': sampleBytes('walk-hik-30'),
    'dances/deep/er/踊り.BVH': sampleBytes('slow-dance-hik-30'),
    'dances/readme.txt': 'not a motion',
    'dances/._walk.bvh': 'what macOS puts beside a file',
    'dances/deep/picture.png': new Uint8Array([1, 2, 3]),
    ...Object.fromEntries(many.map((name) => [name, tinyBvh(30)])),
  });
  await app.openWith(join(folder, 'dances'));
  await expect(page.locator('.library-count')).toHaveText('132 clips');
  await expect(app.toast).toHaveCount(0);
  await app.field('Filter by name or label').fill('踊り');
  await app.expectNames('踊り.BVH');
  await app.row('踊り.BVH').getByRole('button').first().click();
  await expect(app.section('Result')).toContainText('13 keyposes');
  await app.tab('Doctor');
  await expect(app.section('Recording')).toContainText('dances/deep/er');
});

test('a folder and files without a motion are told, and leave the page as it was', async ({
  app,
  page,
}) => {
  const folder = temporaryFolder();
  const [, picture] = writeFiles(folder, { 'empty/a.txt': 'a', 'picture.png': 'b' });
  await app.open();
  await app.drop(join(folder, 'empty'));
  await expect(app.toast).toHaveText('No BVH files in empty.');
  await app.drop(picture);
  await expect(app.toast).toHaveText('picture.png is no BVH file.');
  await expect(
    page.getByRole('heading', {
      name: 'See the keyposes of a motion, and which motions are alike.',
    }),
  ).toBeVisible();
});

test('a .zip: its motions with their folders, and no row for what else is in it', async ({
  app,
  page,
}) => {
  const archive = zipSync({
    'set/walk.bvh': sampleBytes('walk-hik-30'),
    'set/舞/踊り.bvh': sampleBytes('slow-dance-hik-30'),
    'set/notes.txt': new TextEncoder().encode('notes'),
    '__MACOSX/set/._walk.bvh': new Uint8Array([0, 5, 22, 7]),
  });
  await app.openWith(...writeFiles(temporaryFolder(), { 'set.zip': archive }));
  await app.expectNames('walk.bvh', '踊り.bvh');
  await expect(page.locator('.clip.ready')).toHaveCount(2);
  await app.row('踊り.bvh').getByRole('button').first().click();
  await app.tab('Doctor');
  await expect(app.section('Recording')).toContainText('set/舞');
});

test('an archive that is none says so', async ({ app }) => {
  await app.open();
  await app.drop(...writeFiles(temporaryFolder(), { 'torn.zip': 'PK, but no archive' }));
  await expect(app.toast).toContainText('torn.zip: This is not a .zip archive');
});

test('a broken file among good ones: a row with line and reason, the others fine', async ({
  app,
  page,
}) => {
  const { text, line } = withShortRow('walk-hik-30');
  const paths = writeFiles(temporaryFolder(), {
    'a.bvh': sampleBytes('walk-hik-30'),
    'short.bvh': text,
    'numbers.bvh': '1 2 3\n4 5 6\n',
    'nothing.bvh': '',
    'z.bvh': sampleBytes('walk-poser-30'),
  });
  await app.openWith(...paths);
  await expect(page.locator('.clip.ready')).toHaveCount(2);
  await expect(page.locator('.clip.failed')).toHaveCount(3);
  await expect(app.row('short.bvh')).toContainText(`line ${line}: Found`);
  await expect(app.row('numbers.bvh')).toContainText('where HIERARCHY was expected');
  await expect(app.row('nothing.bvh')).toContainText('The file is empty');
  await expect(app.row('z.bvh')).toContainText('10 keyposes');
  await expect(app.toast).toHaveText('3 of 5 files could not be read');
  await expect(app.openName).toHaveText(/^[az]\.bvh$/);

  await app.row('short.bvh').getByRole('button').first().click();
  const reason = page.getByRole('alert');
  await expect(reason).toContainText('This file could not be read');
  await expect(reason).toContainText(new RegExp(`short\\.bvh · line ${line}, column \\d+`));
  await app.row('a.bvh').getByRole('button').first().click();
  await expect(reason).toHaveCount(0);
  await expect(app.section('Result')).toContainText('10 keyposes');
});

test('cancel: idle again, the other clips still there', async ({ app }) => {
  const folder = temporaryFolder();
  const [walk] = sampleFiles('walk-hik-30');
  const [long, next] = writeFiles(folder, {
    'long.bvh': longText('slow-dance-hik-120', 80e6),
    'next.bvh': sampleBytes('walk-hik-60'),
  });
  // One file is read before a test can press a button: many names for the same bytes take longer.
  const longs = Array.from({ length: 20 }, (_, index) => join(folder, `long-${index}.bvh`));
  for (const path of longs) linkSync(long, path);
  await app.openWith(walk);
  await app.drop(...longs);
  await app.button('Cancel reading').click();
  await expect(app.toast).toHaveText(/^Stopped\./);
  await expect(app.button('Cancel reading')).toHaveCount(0);
  expect(await app.rows.count()).toBeLessThan(1 + longs.length);
  await app.row('walk-hik-30.bvh').click();
  await expect(app.section('Result')).toContainText('10 keyposes');
  await app.drop(next);
  await expect(app.row('next.bvh')).toContainText('10 keyposes');
});

test('the buttons of the empty page pick files and a folder', async ({ app, page }) => {
  const folder = temporaryFolder();
  const [, text] = writeFiles(folder, {
    'set/inner/walk.bvh': sampleBytes('walk-hik-30'),
    'set/notes.txt': 'notes',
  });
  await app.open();
  const choosing = page.waitForEvent('filechooser');
  await app.button('Choose a folder').click();
  await (await choosing).setFiles(join(folder, 'set'));
  await app.settled();
  await app.expectNames('walk.bvh');
  await app.tab('Doctor');
  await expect(app.section('Recording')).toContainText('set/inner');
  await app.button('Add motions').click();
  const adding = page.waitForEvent('filechooser');
  await page.getByRole('menuitem', { name: 'Add files…' }).click();
  await (await adding).setFiles([text, ...sampleFiles('walk-hik-60')]);
  await app.settled();
  await app.expectNames('walk.bvh', 'walk-hik-60.bvh');
  await expect(app.toast).toHaveText('notes.txt is no BVH file.');
});

test('files of the same name are kept apart; the same file twice is one row', async ({
  app,
  page,
}) => {
  const folder = temporaryFolder();
  const [first] = writeFiles(folder, {
    'set/left/walk.bvh': sampleBytes('walk-hik-30'),
    'set/right/walk.bvh': sampleBytes('slow-dance-hik-30'),
  });
  await app.openWith(join(folder, 'set'));
  await app.expectNames('set/left walk.bvh', 'set/right walk.bvh');
  await expect(app.rows.first()).toContainText('10 keyposes');
  await expect(app.rows.nth(1)).toContainText('13 keyposes');
  await app.rows.nth(1).getByRole('button').first().click();
  await expect(app.openName).toContainText('set/right');
  await app.drop(join(folder, 'set'));
  await expect(app.toast).toHaveText('2 files were in the library already');
  await expect(app.rows).toHaveCount(2);
  await app.drop(first);
  await expect(page.locator('.library-count')).toHaveText('3 clips');
});

test('what went wrong is told beside the labels of the timeline, not over them', async ({
  app,
  page,
}) => {
  const [text] = writeFiles(temporaryFolder(), { 'notes.txt': 'notes' });
  await app.openWith(...sampleFiles('walk-hik-30'));
  await app.drop(text);
  await expect(app.toast).toHaveText('notes.txt is no BVH file.');
  const box = async (selector: string) => (await page.locator(selector).boundingBox())!;
  const toast = await box('.toast');
  expect(toast.x + toast.width).toBeLessThanOrEqual((await box('.timeline')).x);
  expect(toast.y + toast.height).toBeLessThanOrEqual((await box('.library-foot')).y);
});
