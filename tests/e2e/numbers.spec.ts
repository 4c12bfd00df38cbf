/** Every number that the page shows of a clip is the command line's. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { dataFolder } from '../support/data';
import type { AppPage } from './support/app-page';
import { expectedClip, shownClip } from './support/clip-figures';
import { decimal, figure, length, plural, probability } from './support/english';
import { expectedKeypose, shownKeypose } from './support/keypose-figures';
import { sampleFiles } from './support/motions';
import { type AnovaReport, type Report, reportOf, tracesOf } from './support/reports';
import { expect, test } from './support/test';

/** What a unit is called on the page, and its metres. */
const units: Readonly<Record<string, readonly [string, number]>> = {
  m: ['m', 1],
  dm: ['dm', 0.1],
  '1/17.72 m': ['CMU', 1 / 17.72],
  in: ['inch', 0.0254],
  cm: ['cm', 0.01],
  mm: ['mm', 0.001],
};

const anovaText = (anova: AnovaReport | null): string =>
  anova === null
    ? 'ANOVA is not defined for this cut.'
    : `ANOVA F(${anova.df_between}, ${anova.df_within}) = ${decimal(anova.f, 1)}, p ${probability(anova.p)}`;

function cutText(sureness: number | null): string {
  if (sureness === null) return 'cut clear';
  return `cut ${sureness < 1.5 ? 'uncertain' : 'clear'} (${decimal(sureness, 1)})`;
}

async function expectResult(app: AppPage, report: Report): Promise<void> {
  const { keyposes, candidates, clusters, anova, sureness } = report;
  const zero = candidates.filter(({ intensity }) => intensity === 0).length;
  await app.tab('Method');
  const result = app.section('Result');
  await expect(result.locator('.result-count')).toHaveText(plural(keyposes.length, 'keypose'));
  await expect(result).toContainText(
    `${plural(candidates.length, 'candidate')}, ${zero} of zero intensity, in ${plural(clusters, 'cluster')}.`,
  );
  await expect(result).toContainText(anovaText(anova));
  await expect(result.locator('.sureness')).toHaveText(cutText(sureness));
}

async function expectRecording(app: AppPage, report: Report): Promise<void> {
  const { frames, frame_time_s: step, frame_rate_hz: rate } = report;
  await app.tab('Doctor');
  const recording = app.section('Recording');
  await expect(recording).toContainText(
    `${decimal(frames, 0)} · ${decimal((frames - 1) * step, 1)} s`,
  );
  const shown = Number(await recording.getByLabel('Frame rate', { exact: true }).inputValue());
  expect(shown).toBeCloseTo(rate, 3);
  await expect(recording.getByLabel('Leading frames left out', { exact: true })).toHaveValue(
    String(report.leading_rest_frames),
  );
}

async function expectBody(
  app: AppPage,
  { up, unit, body, ground_height: ground }: Report,
): Promise<void> {
  await app.tab('Body');
  const measures = app.section('Measures');
  const fact = (name: string) =>
    measures.locator('.fact').filter({ hasText: name }).locator('dd').first();
  const [unitName, metres] = units[unit ?? ''] ?? ['unknown', null];
  const inMetres = metres === null ? '' : `, ${decimal(body.height * metres, 2)} m`;
  await expect(fact('Body height')).toHaveText(`${length(body.height)} units${inMetres}`);
  const shown = Number(await measures.getByLabel('Ground', { exact: true }).inputValue());
  expect(shown).toBeCloseTo(ground, Math.abs(ground) < 10 ? 2 : 1);
  await expect(measures.getByLabel('Unit', { exact: true }).locator('option').first()).toHaveText(
    `${unitName} automatic`,
  );
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

const quickly = { intervals: [10, 20, 50, 100] };

/** Goes from keypose to keypose. */
async function expectKeyposes(app: AppPage, path: string, report: Report): Promise<void> {
  const traces = tracesOf(path);
  await app.tab('Method');
  await expect.poll(() => shownClip(app.page)).toEqual(expectedClip(report));
  await app.page.keyboard.press('Home');
  for (const index of report.keyposes.keys()) {
    if (index > 0 || report.keyposes[0]?.frame !== 0) await app.page.keyboard.press('k');
    await expect
      .poll(() => shownKeypose(app.page), quickly)
      .toEqual(expectedKeypose(report, traces, index));
  }
}

async function expectShown(app: AppPage, path: string): Promise<void> {
  const report = reportOf(path);
  await expect(app.openName).toHaveText(path.split('/').pop() ?? '');
  await expectKeyposes(app, path, report);
  await expectResult(app, report);
  await expectRecording(app, report);
  await expectBody(app, report);
  await expectNotes(app, report);
}

for (const id of ['slow-dance-vrm-30', 'tired-dance-poser-60', 'walk-hik-120', 'run-vrm-60']) {
  test(`of the sample ${id}`, async ({ app }) => {
    const [path = ''] = sampleFiles(id);
    await app.openWith(path);
    await expectShown(app, path);
  });
}

interface Golden {
  readonly speed: readonly number[];
  readonly speed_first_frame: number;
}

/** The speed at every keypose is the reference's. */
async function expectSpeeds(app: AppPage, path: string, golden: string): Promise<void> {
  const { speed, speed_first_frame: first } = JSON.parse(readFileSync(golden, 'utf8')) as Golden;
  const speedFigure = app.page.locator('.row-figure').nth(1);
  await app.page.keyboard.press('Home');
  const { keyposes, frames, frame_time_s: step } = reportOf(path);
  for (const { frame } of keyposes) {
    await app.page.keyboard.press('k');
    await app.expectFrame(frame);
    await expect(speedFigure).toHaveText(figure(speed[frame - first] ?? 0));
    await app.page.keyboard.press('Shift+ArrowRight');
    const later = Math.min(frames - 1, frame + Math.round(0.1 / step));
    await app.expectFrame(later);
    await expect(speedFigure).toHaveText(figure(speed[later - first] ?? 0));
    await app.page.keyboard.press('Shift+ArrowLeft');
  }
}

for (const name of ['05_02', '07_01']) {
  test(`of the recording ${name}`, async ({ app }) => {
    const data = dataFolder() ?? '';
    test.skip(data === '', 'no test data');
    const path = join(data, 'cmu', `${name}.bvh`);
    await app.openWith(path);
    await expectShown(app, path);
    await expectSpeeds(app, path, join(data, 'golden', `${name}.json`));
  });
}
