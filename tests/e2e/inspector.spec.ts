/** The side panel: its tabs, every parameter of the method, why a keypose is one, the body, notes, exports. */
import { expectResult } from './support/expect-result';
import {
  sampleFiles,
  sampleText,
  temporaryFolder,
  tinyBvh,
  withRestPose,
  writeFiles,
} from './support/motions';
import { keyposeFramesOf, reportOf } from './support/reports';
import { expect, test } from './support/test';

test('tabs: arrow keys, Home and End; the chosen one is remembered', async ({ app, page }) => {
  await app.openWith(...sampleFiles('walk-hik-30', 'walk-poser-30'));
  const tab = (name: string) => page.getByRole('tab', { name });
  const expectChosen = async (name: string, section: string): Promise<void> => {
    await expect(tab(name)).toHaveAttribute('aria-selected', 'true');
    await expect(tab(name)).toHaveAttribute('tabindex', '0');
    await expect(page.getByRole('tab', { selected: true })).toHaveCount(1);
    await expect(page.getByRole('tabpanel', { name })).toContainText(section);
  };
  await expectChosen('Method', 'Low-pass cut-off');
  await tab('Method').focus();
  await page.keyboard.press('ArrowRight');
  await expectChosen('Body', '16 joints');
  await expect(tab('Body')).toBeFocused();
  await page.keyboard.press('End');
  await expectChosen('Export', 'Traces');
  await page.keyboard.press('ArrowRight');
  await expectChosen('Method', 'Result');
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('ArrowLeft');
  await expectChosen('Doctor', 'Recording');
  await app.expectFrame(0);
  await app.row('walk-poser-30.bvh').getByRole('button').first().click();
  await expectChosen('Doctor', 'Recording');
  await tab('Doctor').focus();
  await page.keyboard.press('Home');
  await expectChosen('Method', 'Result');
});

test('after a press of the pointer the keys go on to play the motion', async ({ app, page }) => {
  await app.openWith(...sampleFiles('walk-hik-30'));
  await app.tab('Body');
  await page.keyboard.press('ArrowRight');
  await app.expectFrame(1);
  await expect(page.getByRole('tab', { name: 'Body' })).toHaveAttribute('aria-selected', 'true');
});

test('Ctrl+Z in the field undoes what was taken from it', async ({ app, page }) => {
  await app.openWith(...sampleFiles('walk-hik-30'));
  const field = page.getByRole('textbox', { name: /^Ratio/ });
  await field.fill('0.8');
  await field.press('Enter');
  await expect(page.locator('.setting.changed')).toHaveCount(1);
  await field.press('Control+z');
  await expect(page.locator('.setting.changed')).toHaveCount(0);
  await expect.poll(() => field.inputValue()).toBe('0.95');
});

const parameters = [
  ['Low-pass cut-off', '4', '--low-pass-hz'],
  ['Finest scale', '5', '--scale-max-hz'],
  ['Coarsest scale', '1,5', '--scale-min-hz'],
  ['Ratio', '0.8', '--scale-ratio'],
] as const;

for (const [label, value, option] of parameters) {
  test(`${label}: the result follows, as on the command line; back by its reset, undo, redo`, async ({
    app,
    page,
  }) => {
    const [path = ''] = sampleFiles('slow-dance-vrm-30');
    const usual = reportOf(path);
    const other = reportOf(path, option, value.replace(',', '.'));
    expect(keyposeFramesOf(other)).not.toEqual([]);
    await app.openWith(path);
    await expectResult(app, usual);
    const field = page.getByRole('textbox', { name: new RegExp(`^${label}`) });
    const before = await field.inputValue();
    await field.fill(value);
    await field.press('Enter');
    await expect(field).toHaveValue(value.replace(',', '.'));
    await expectResult(app, other);
    await expect(page.locator('.setting.changed')).toHaveCount(1);
    await app
      .section('Method')
      .getByRole('button', { name: /^Back to the default/ })
      .click();
    await expect(field).toHaveValue(before);
    await expectResult(app, usual);
    await app.button(/^Undo/).click();
    await expectResult(app, other);
    await app.button(/^Undo/).click();
    await expectResult(app, usual);
    await expect(app.section('Method').getByRole('button', { name: 'Reset' })).toBeDisabled();
    await app.button(/^Redo/).click();
    await expectResult(app, other);
    await app.section('Method').getByRole('button', { name: 'Reset' }).click();
    await expectResult(app, usual);
    await expect(page.locator('.setting.changed')).toHaveCount(0);
  });
}

test('selection: each rule, for every clip', async ({ app }) => {
  const paths = sampleFiles('walk-hik-60', 'slow-dance-poser-60');
  await app.openWith(...paths);
  for (const [rule, option] of [
    ['Paper’s literal rule', '--literal'],
    ['Even split', '--even-split'],
    ['Automatic', ''],
  ] as const) {
    await app.field('Selection').selectOption(rule);
    for (const path of paths) {
      await app
        .row(path.split('/').pop() ?? '')
        .getByRole('button')
        .first()
        .click();
      await expectResult(app, reportOf(path, ...[option].filter(Boolean)));
    }
  }
});

test('what a parameter cannot be is said, and not taken', async ({ app, page }) => {
  await app.openWith(...sampleFiles('walk-hik-30'));
  const method = app.section('Method');
  const field = (name: string) => page.getByRole('textbox', { name: new RegExp(`^${name}`) });
  for (const [name, value, why] of [
    ['Low-pass cut-off', 'ten', 'Write a number'],
    ['Low-pass cut-off', '0', 'A frequency from 0.01'],
    ['Finest scale', '0.1', 'cannot be coarser than the coarsest, 0.2 Hz'],
    ['Coarsest scale', '9', 'cannot be finer than the finest, 8 Hz'],
    ['Ratio', '1', 'above 0 and below 1'],
    ['Ratio', '0.9999', 'at most 1,000 are possible'],
  ] as const) {
    await field(name).fill(value);
    await field(name).press('Enter');
    await expect(method.getByRole('alert').filter({ hasText: why })).toBeVisible();
    await expect(field(name)).toHaveAttribute('aria-invalid', 'true');
    await expect(field(name)).toHaveValue(value);
  }
  await expect(app.button('Undo')).toBeDisabled();
  await field('Ratio').fill('0.9');
  await field('Ratio').press('Enter');
  await expect(app.button('Undo: ratio of the scales')).toBeEnabled();
  await expect(method.getByRole('alert')).toHaveCount(0);
  await expect(field('Low-pass cut-off')).toHaveValue('10');
});

test('a value that is right alone but not with the others is refused', async ({ app, page }) => {
  await app.openWith(...sampleFiles('walk-hik-30'));
  const field = (name: string) => page.getByRole('textbox', { name });
  for (const [name, value] of [
    ['Coarsest scale', '0.05'],
    ['Ratio', '0.995'],
  ] as const) {
    await app.settled();
    await field(name).fill(value);
    await field(name).press('Enter');
    await expect(app.button('Undo: coarsest scale')).toBeEnabled();
  }
  const method = app.section('Method');
  await expect(method.getByRole('alert')).toContainText('at most 1,000');
  await expect(app.button('Undo: coarsest scale')).toBeEnabled();
});

test('a held arrow key is one step of the history', async ({ app }) => {
  await app.openWith(...sampleFiles('walk-hik-30'));
  const field = app.field('Low-pass cut-off');
  // As quickly as a held key repeats, however slow the machine is.
  await field.evaluate((input) => {
    const press = { key: 'ArrowDown', bubbles: true, cancelable: true };
    for (let count = 0; count < 4; count++)
      input.dispatchEvent(new KeyboardEvent('keydown', press));
  });
  await expect(field).toHaveValue('6');
  await app.button('Undo: low-pass cut-off').click();
  await expect(field).toHaveValue('10');
  await expect(app.button('Undo')).toBeDisabled();
});

test('why: it follows the playhead, and goes to the neighbours by intensity', async ({
  app,
  page,
}) => {
  const [path = ''] = sampleFiles('slow-dance-hik-30');
  const { keyposes, candidates, frame_time_s: step } = reportOf(path);
  await app.openWith(path);
  const why = app.section('Why here');
  const order = [...candidates].sort((a, b) => b.intensity - a.intensity || a.frame - b.frame);
  const expectKeypose = async (number: number): Promise<void> => {
    const { frame, time_s: time, intensity } = keyposes[number - 1] ?? keyposes[0];
    const rank = order.findIndex((one) => one.frame === frame) + 1;
    await expect(why.locator('h3')).toContainText(`Keypose ${number} ${time.toFixed(2)} s`);
    await expect(why.locator('h3')).toContainText(
      `intensity ${intensity.toFixed(1)}, rank ${rank}`,
    );
    await expect(why.getByRole('img')).toHaveAccessibleName(/Its trace runs from .* Hz/);
    await expect(why.getByRole('row')).toHaveCount(5);
    await expect(why).toContainText(/Strongest at \d+\.\d Hz\. Body parts here/);
  };
  await expectKeypose(1);
  await page.keyboard.press('k');
  await page.keyboard.press('k');
  await page.keyboard.press('k');
  await expectKeypose(3);
  await page.keyboard.press('End');
  await expectKeypose(keyposes.length);

  // From the least intense keypose on come candidates that were dropped.
  const weakest = order.findIndex((one) => one.frame === keyposes.at(-1)?.frame);
  const stronger = order[weakest - 1];
  const go = async (name: 'Stronger' | 'Weaker', to: { frame: number } | undefined) => {
    await why.getByRole('button', { name }).click();
    await app.expectFrame(to?.frame ?? -1);
    await expect(why.locator('h3')).toContainText(`${((to?.frame ?? 0) * step).toFixed(2)} s`);
  };
  if (stronger) await go('Stronger', stronger);
  else await go('Weaker', order[1]);
  const last = order.findIndex((one) => one.frame === Math.min(...keyposes.map((k) => k.frame)));
  await page.keyboard.press('Home');
  for (let at = last + 1; at <= keyposes.length; at++) {
    const next = order[at];
    if (!next || next.intensity === 0) break;
    await go('Weaker', next);
  }
  const dropped = order[keyposes.length];
  if (dropped && dropped.intensity > 0) {
    await expect(why).toContainText('Candidate');
    await expect(why).toContainText('No keypose: its intensity is below the cut at');
    await page.keyboard.press('ArrowRight');
    await expect(why.locator('h3')).toContainText('Keypose');
  }
});

test('why: the other curves show their keyposes, and lead there', async ({ app, page }) => {
  await app.openWith(...sampleFiles('slow-dance-hik-30'));
  const chart = app.section('Why here').getByRole('img');
  const box = await chart.boundingBox();
  const end = await chart
    .locator('.why-other')
    .first()
    .evaluate((path: SVGPathElement) => path.getAttribute('d')?.split('L').at(-1) ?? '');
  const [x = 0, y = 0] = end.split(' ').map(Number);
  await page.mouse.move((box?.x ?? 0) + x, (box?.y ?? 0) + y);
  await expect(chart.locator('.why-hovered')).toHaveCount(1);
  await page.mouse.click((box?.x ?? 0) + x, (box?.y ?? 0) + y);
  await expect.poll(() => app.frame()).toBeGreaterThan(0);
});

test('no keyposes, another body: one sentence each', async ({ app }) => {
  const folder = temporaryFolder();
  const files = { 'short.bvh': tinyBvh(2), 'still.bvh': tinyBvh(60) };
  await app.openWith(...writeFiles(folder, files));
  await app.row('short.bvh').getByRole('button').first().click();
  const why = app.section('Why here');
  await expect(why).toContainText('this motion could not be analysed');
  await app.row('still.bvh').getByRole('button').first().click();
  await expect(why).toContainText(/Parts of the body are compared in human bodies only|no keypose/);
  await app.tab('Body');
  await expect(app.section('Body')).toContainText('not human');
  await expect(app.section('16 joints')).toHaveCount(0);
});

test('the switch of the doctor takes the leading rest pose in and out', async ({ app, page }) => {
  const files = { 'rest.bvh': withRestPose('slow-dance-hik-30') };
  const [path = ''] = writeFiles(temporaryFolder(), files);
  const usual = reportOf(path);
  expect(usual.leading_rest_frames).toBe(1);
  await app.openWith(path);
  await app.tab('Doctor');
  const notes = app.section('Notes');
  const leaveOut = notes.getByRole('switch');
  await expect(leaveOut).toBeChecked();
  await app.field('Leading frames left out').press('Tab');
  await page.keyboard.press('Tab');
  await expect(leaveOut).toBeFocused();
  await page.keyboard.press('Space');
  await expect(leaveOut).not.toBeChecked();
  await expect(app.field('Leading frames left out')).toHaveValue('0');
  await app.settled();
  await expect(notes).toContainText('by hand: 0');
  await leaveOut.click();
  await expect(app.field('Leading frames left out')).toHaveValue(String(usual.leading_rest_frames));
});

test('notes: warnings first, places, ways to the field that overrules, and none', async ({
  app,
  page,
}) => {
  const odd = sampleText('walk-hik-30').replace(/Frame Time:.*/, 'Frame Time: 30');
  await app.openWith(...writeFiles(temporaryFolder(), { 'odd.bvh': odd }));
  await expect(page.getByRole('tab', { name: 'Doctor' })).toContainText(/\d/);
  await app.tab('Doctor');
  const notes = app.section('Notes');
  const line = odd.split('\n').findIndex((one) => one.startsWith('Frame Time')) + 1;
  await expect(notes.locator('.note').first()).toContainText('Warning:');
  await expect(notes.locator('.note').first()).toContainText(`Line ${line}`);
  await notes.getByRole('button', { name: 'Frame rate' }).click();
  await expect(app.field('Frame rate')).toBeFocused();

  await app.drop(...sampleFiles('walk-vrm-30'));
  await app.row('walk-vrm-30.bvh').getByRole('button').first().click();
  const { notes: all } = reportOf(sampleFiles('walk-vrm-30')[0] ?? '');
  if (all.length === 0) await expect(notes).toContainText('No notes');
  else await expect(notes.locator('.note')).toHaveCount(all.length);
});

test('a thousand notes come by the hundred', async ({ app }) => {
  const text = sampleText('walk-hik-30');
  const jointless = Array.from({ length: 900 }, (_, n) => `unknown ${n}`).join('\n');
  const many = text.replace('MOTION', `${jointless}\nMOTION`);
  await app.openWith(...writeFiles(temporaryFolder(), { 'many.bvh': many }));
  const { notes } = reportOf(writeFiles(temporaryFolder(), { 'many.bvh': many })[0] ?? '');
  await app.tab('Doctor');
  const shown = app.section('Notes').locator('.note');
  await expect(shown).toHaveCount(Math.min(100, notes.length));
  if (notes.length <= 100) return;
  await app
    .section('Notes')
    .getByRole('button', { name: /^Show \d+ more/ })
    .click();
  await expect(shown).toHaveCount(Math.min(200, notes.length));
});

test('exports wait for the result of a change', async ({ app, page }) => {
  await page.clock.install();
  await app.openWith(...sampleFiles('walk-hik-60'));
  await page.clock.pauseAt(Date.now() + 60_000);
  await app.field('Selection').selectOption('Even split');
  await page.getByRole('tab', { name: 'Export' }).click();
  await page.clock.runFor(100);
  const buttons = app.section('Export').getByRole('button');
  await expect(buttons).toHaveCount(6);
  for (const button of await buttons.all()) await expect(button).toBeDisabled();
  await page.clock.resume();
  for (const button of await buttons.all()) await expect(button).toBeEnabled();
});
