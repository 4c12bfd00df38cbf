/** What is taken away as a file is what the command line writes, byte for byte. */
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import type { AppPage } from './support/app-page';
import { sampleFiles, sampleBytes, temporaryFolder, writeFiles } from './support/motions';
import { exportOf, keyposeFramesOf, reportOf } from './support/reports';
import { expect, test } from './support/test';

const tables = ['Keyposes', 'Candidates', 'Traces'] as const;
const forms = ['csv', 'json'] as const;

type Table = (typeof tables)[number];
type Form = (typeof forms)[number];

/** How the command line is asked for a table. */
const optionsOf: Readonly<Record<Table, readonly string[]>> = {
  Keyposes: [],
  Candidates: ['--candidates'],
  Traces: ['--traces'],
};

/** Presses a button of Export; the file's name and what is in it. */
async function exported(
  app: AppPage,
  form: Form,
  table: Table = 'Keyposes',
): Promise<{ name: string; text: string }> {
  await app.tab('Export');
  const download = app.page.waitForEvent('download');
  await app
    .section('Export')
    .getByRole('button', { name: `${table}, ${form.toUpperCase()}` })
    .click();
  const file = await download;
  return { name: file.suggestedFilename(), text: readFileSync(await file.path(), 'utf8') };
}

test('CSV and JSON, before and after decisions', async ({ app }) => {
  const [path = ''] = sampleFiles('slow-dance-poser-30');
  await app.openWith(path);
  const csv = await exported(app, 'csv');
  expect(csv.name).toBe('slow-dance-poser-30.keyposes.csv');
  expect(csv.text).toBe(exportOf(path, 'csv'));
  const frames = csv.text
    .trimEnd()
    .split('\r\n')
    .slice(1)
    .map((row) => Number(row.split(',')[3]));
  expect(frames).toEqual(keyposeFramesOf(reportOf(path)));
  await expect(app.toast).toHaveText('slow-dance-poser-30.keyposes.csv saved');

  const json = await exported(app, 'json');
  expect(json.name).toBe('slow-dance-poser-30.keyposes.json');
  expect(json.text).toBe(exportOf(path, 'json'));

  const decided = ['--frame-rate-hz', '24', '--leading-rest-frames', '50', '--up=+Z'];
  await app.tab('Doctor');
  await app.field('Frame rate').fill('24');
  await app.field('Leading frames left out').fill('50');
  await app.field('Leading frames left out').blur();
  await app.tab('Body');
  await app.field('Up axis').selectOption('+Z');
  await app.settled();
  const again = await exported(app, 'json');
  expect(again.text).not.toBe(json.text);
  expect(again.text).toBe(exportOf(path, 'json', ...decided));
  expect((await exported(app, 'csv')).text).toBe(exportOf(path, 'csv', ...decided));
});

/** Every table in both forms; whether all are the command line's with these options. */
async function expectAll(app: AppPage, path: string, ...options: string[]): Promise<void> {
  for (const table of tables) {
    for (const form of forms) {
      const { name, text } = await exported(app, form, table);
      expect(name).toMatch(new RegExp(`\\.${table.toLowerCase()}\\.${form}$`));
      const expected = exportOf(path, form, ...options, ...optionsOf[table]);
      // The texts are too long to be shown where they differ.
      expect(text === expected, `${table} ${form}`).toBe(true);
    }
  }
}

test('keyposes, candidates and traces, before and after a change of the method', async ({
  app,
}) => {
  const [path = ''] = sampleFiles('slow-dance-vrm-30');
  await app.openWith(path);
  await expectAll(app, path);
  await app.tab('Method');
  await app.field('Selection').selectOption('Even split');
  const finest = app.page.getByRole('textbox', { name: /^Finest scale/ });
  await finest.fill('5');
  await finest.press('Enter');
  await app.settled();
  await expectAll(app, path, '--even-split', '--scale-max-hz', '5');
});

test('a name that needs quotes, and letters beyond ASCII', async ({ app }) => {
  const name = '踊り, "一".bvh';
  const [path = ''] = writeFiles(temporaryFolder(), { [name]: sampleBytes('walk-hik-30') });
  await app.openWith(path);
  expect((await exported(app, 'csv')).text).toBe(exportOf(path, 'csv'));
  expect((await exported(app, 'json')).text).toBe(exportOf(path, 'json'));
});

test('of namesakes, the open one is taken', async ({ app }) => {
  const folder = temporaryFolder();
  const paths = writeFiles(folder, {
    'set/a/walk.bvh': sampleBytes('walk-hik-30'),
    'set/b/walk.bvh': sampleBytes('walk-poser-60'),
  });
  await app.openWith(join(folder, 'set'));
  for (const [index, path] of paths.entries()) {
    await app.rows.nth(index).getByRole('button').first().click();
    await expect(app.openName).toContainText(dirname(path).slice(folder.length + 1));
    expect((await exported(app, 'csv')).text).toBe(exportOf(path, 'csv'));
  }
});
