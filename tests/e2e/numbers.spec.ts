/** Every number that the page shows of a clip is the command line's. */
import { join } from 'node:path';
import { dataFolder } from '../support/data';
import type { AppPage } from './support/app-page';
import { sampleFiles } from './support/motions';
import { type Report, reportOf } from './support/reports';
import { expect, test } from './support/test';

const digitsFor = (value: number): number =>
  Math.abs(value) >= 100 ? 1 : Math.abs(value) >= 10 ? 2 : 3;

const english = (value: number, digits: number): string =>
  value.toLocaleString('en', { minimumFractionDigits: digits, maximumFractionDigits: digits });

const inUnits = (value: number): string => `${english(value, digitsFor(value))} units`;

async function expectResult(app: AppPage, report: Report): Promise<void> {
  const { keyposes, candidates, clusters, anova, sureness } = report;
  const zero = candidates.filter(({ intensity }) => intensity === 0).length;
  await app.tab('Method');
  const result = app.section('Result');
  await expect(result.locator('.result-count')).toHaveText(`${keyposes.length} keyposes`);
  await expect(result).toContainText(
    `${candidates.length} candidates, ${zero} of zero intensity, in ${clusters} cluster${clusters === 1 ? '' : 's'}.`,
  );
  const test = anova === null ? 'ANOVA is not defined' : `= ${english(anova.f, 1)}, p`;
  await expect(result).toContainText(test);
  const cut =
    sureness === null
      ? /^cut clear$/
      : new RegExp(
          `cut ${sureness < 1.5 ? 'uncertain' : 'clear'} \\(${english(sureness, 1).replace('.', '\\.')}\\)`,
        );
  await expect(result.locator('.sureness')).toHaveText(cut);
}

async function expectRecording(app: AppPage, report: Report): Promise<void> {
  const { frames, frame_time_s: step, frame_rate_hz: rate } = report;
  await app.tab('Doctor');
  const recording = app.section('Recording');
  await expect(recording).toContainText(
    `${english(frames, 0)} · ${english((frames - 1) * step, 1)} s`,
  );
  const shown = Number(await recording.getByLabel('Frame rate', { exact: true }).inputValue());
  expect(shown).toBeCloseTo(rate, 3);
  await expect(recording.getByLabel('Leading frames left out', { exact: true })).toHaveValue(
    String(report.leading_rest_frames),
  );
}

async function expectBody(
  app: AppPage,
  { up, body, ground_height: ground }: Report,
): Promise<void> {
  await app.tab('Body');
  const measures = app.section('Measures');
  const fact = (name: string) =>
    measures.locator('.fact').filter({ hasText: name }).locator('dd').first();
  await expect(fact('Body height')).toContainText(inUnits(body.height));
  await expect(fact('Ground')).toHaveText(inUnits(ground));
  await expect(
    measures.getByLabel('Up axis', { exact: true }).locator('option').first(),
  ).toHaveText(`${up.replace('-', '−')} automatic`);
  const rows = await app
    .section('16 joints')
    .locator('tbody tr')
    .evaluateAll((all) =>
      all.map((row) => ({
        role: row.querySelector('th')?.textContent.trim().toLowerCase().replace(' ', '_') ?? '',
        joint: row.querySelector('td')?.title ?? '',
        source: row.querySelector<HTMLElement>('.joint-source')?.title ?? '',
      })),
    );
  const sources: Record<string, string> = {
    name: 'by name',
    shape: 'by shape',
    fallback: 'replaced',
  };
  const joints = body.joints.map(({ role, joint, source }) => ({
    role,
    joint,
    source: sources[source] ?? '',
  }));
  const byRole = (a: { role: string }, b: { role: string }): number => (a.role < b.role ? -1 : 1);
  const pelvis = { role: 'pelvis', joint: body.pelvis, source: '' };
  expect(rows.sort(byRole)).toEqual([...joints, pelvis].sort(byRole));
}

async function expectNotes(app: AppPage, { notes }: Report): Promise<void> {
  await app.tab('Doctor');
  const shown = await app
    .section('Notes')
    .locator('.note')
    .evaluateAll((all) =>
      all.map((note) => {
        const text = (name: string): string =>
          note.querySelector(`.note-${name}`)?.textContent ?? '';
        return text('assumed') ? `${text('what')}; ${text('assumed')}` : `${text('what')}.`;
      }),
    );
  const plain = (texts: readonly string[]): string[] =>
    texts.map((one) => one.toLowerCase()).sort();
  expect(plain(shown)).toEqual(plain(notes.map(({ message }) => message)));
}

async function expectShown(app: AppPage, path: string): Promise<void> {
  const report = reportOf(path);
  const count = report.keyposes.length;
  const name = path.split('/').pop() ?? '';
  await app.row(name).getByRole('button').first().click();
  await expect(app.openName).toHaveText(name);
  await expect(app.row(name)).toContainText(`${count} keyposes`);
  await expect(app.page.locator('.strip-count')).toHaveText(String(count));
  await expect(app.page.locator('.clock-last')).toHaveText(`/ ${report.frames - 1}`);
  await expectResult(app, report);
  await expectRecording(app, report);
  await expectBody(app, report);
  await expectNotes(app, report);
}

test('samples of every rig and rate', async ({ app }) => {
  const paths = sampleFiles('slow-dance-vrm-30', 'slow-dance-poser-60', 'walk-hik-120');
  await app.openWith(...paths);
  for (const path of paths) await expectShown(app, path);
});

test('recordings', async ({ app }) => {
  const data = dataFolder();
  test.skip(data === null, 'no test data');
  const paths = ['05_02.bvh', '05_03.bvh'].map((name) => join(data ?? '', 'cmu', name));
  await app.openWith(...paths);
  for (const path of paths) await expectShown(app, path);
});
