/** What a person decides about a recording is shown, computed with, and can be undone and redone. */
import { readFileSync } from 'node:fs';
import { sampleFiles } from './support/motions';
import { reportOf } from './support/reports';
import { expect, test } from './support/test';

test('frame rate: time and keyposes follow; keys undo and redo it', async ({ app, page }) => {
  const [path = ''] = sampleFiles('walk-hik-60');
  const usual = reportOf(path);
  const slower = reportOf(path, '--frame-rate-hz', '24');
  const last = usual.frames - 1;
  const rate = app.field('Frame rate');
  const row = app.row('walk-hik-60.bvh');
  await app.openWith(path);
  await app.tab('Doctor');
  const expectRate = async (hz: number, report: typeof usual): Promise<void> => {
    await expect(rate).toHaveValue(String(hz));
    await app.settled();
    await expect(row).toContainText(`${(last / hz).toFixed(1)} s · ${hz} Hz`);
    await app.tab('Method');
    await expect(app.section('Result')).toContainText(`${report.candidates.length} candidates`);
    await app.tab('Doctor');
    await expect(row).toContainText(`${report.keyposes.length} keypose`);
    await page.keyboard.press('End');
    await expect(page.locator('.clock-time')).toHaveText((last / hz).toFixed(3));
  };
  await expectRate(60, usual);
  await rate.fill('24');
  await rate.press('Enter');
  await rate.blur();
  await expectRate(24, slower);
  await page.keyboard.press('Control+z');
  await expectRate(60, usual);
  await page.keyboard.press('Control+Shift+Z');
  await expectRate(24, slower);
  await app.button('Undo: frame rate').click();
  await expectRate(60, usual);
  await expect(app.button('Redo: frame rate')).toBeEnabled();
});

test('leading frames: taken, left out of the result, and back to automatic', async ({
  app,
  page,
}) => {
  const [path = ''] = sampleFiles('slow-dance-hik-30');
  await app.openWith(path);
  await app.tab('Doctor');
  const field = app.field('Leading frames left out');
  const automatic = await field.inputValue();
  await field.fill('100');
  await field.blur();
  const decided = reportOf(path, '--leading-rest-frames', '100');
  await expect(app.section('Notes')).toContainText('Leading frames left out by hand: 100');
  await app.tab('Method');
  await expect(app.section('Result')).toContainText(`${decided.keyposes.length} keyposes`);
  await app.tab('Doctor');
  await page.keyboard.press('Home');
  await expect(app.caption).toContainText('leading rest pose, left out');
  await app.button('Back to automatic: Leading frames left out').click();
  await expect(field).toHaveValue(automatic);
  await app.settled();
  await expect(app.section('Notes')).not.toContainText('by hand');
});

test('a refused value does not follow to another clip, nor outlive an undo', async ({ app }) => {
  await app.openWith(...sampleFiles('walk-hik-60'), ...sampleFiles('slow-dance-hik-30'));
  await app.tab('Doctor');
  const rate = app.field('Frame rate');
  await rate.fill('24');
  await rate.blur();
  await app.settled();
  await rate.fill('-3');
  await rate.blur();
  await app.button('Undo: frame rate').click();
  await expect(rate).toHaveValue('60');
  await rate.fill('-3');
  await rate.blur();
  await app.row('slow-dance-hik-30.bvh').click();
  await expect(rate).toHaveValue('30');
  expect(await rate.evaluate((input: HTMLInputElement) => input.validationMessage)).toBe('');
});

test('a value that cannot be is not taken', async ({ app }) => {
  await app.openWith(...sampleFiles('walk-hik-30'));
  await app.tab('Doctor');
  const rate = app.field('Frame rate');
  for (const wrong of ['0', '-3', '2001', '']) {
    await rate.fill(wrong);
    await rate.blur();
    expect(await rate.evaluate((input: HTMLInputElement) => input.validity.valid)).toBe(false);
  }
  await expect(app.row('walk-hik-30.bvh')).toContainText('30 Hz');
  await expect(app.button('Undo')).toBeDisabled();
});

test('up axis, unit and ground: body height and ground follow', async ({ app, page }) => {
  const [path = ''] = sampleFiles('walk-hik-30');
  await app.openWith(path);
  await app.tab('Body');
  const body = app.section('Measures');
  await app.field('Up axis').selectOption('+Z');
  const sideways = reportOf(path, '--up=+Z');
  const ground = app.field('Ground');
  const shown = async (): Promise<number> => Number(await ground.inputValue());
  await expect
    .poll(async () => Math.abs((await shown()) - sideways.ground_height))
    .toBeLessThan(0.06);
  const found = await ground.inputValue();
  await ground.fill('-12.5');
  await ground.press('Enter');
  await ground.blur();
  await app.settled();
  await app.tab('Export');
  const download = page.waitForEvent('download');
  await app.button('Keyposes, JSON').click();
  const saved: unknown = JSON.parse(readFileSync(await (await download).path(), 'utf8'));
  expect(saved).toEqual(reportOf(path, '--up=+Z', '--ground-height=-12.5'));
  expect(saved).toMatchObject({ ground_height: -12.5, ground_source: 'user' });
  await app.tab('Body');
  await app.button('Back to automatic: Ground').click();
  await expect(ground).toHaveValue(found);
  await app.field('Unit').selectOption('m');
  await expect(body).toContainText(`units, ${reportOf(path).body.height.toFixed(2)} m`);
  await app.field('Unit').selectOption('');
  await expect(body).not.toContainText(`units, ${reportOf(path).body.height.toFixed(2)} m`);
  for (const what of ['unit', 'unit', 'ground', 'ground', 'up axis']) {
    await app.button(`Undo: ${what}`).click();
  }
  await expect(app.button('Undo')).toBeDisabled();
  await expect(app.field('Up axis')).toHaveValue('');
});

test('a removed clip comes back, with what was decided about it', async ({ app, page }) => {
  await app.openWith(...sampleFiles('walk-hik-30', 'walk-poser-30'));
  await app.row('walk-hik-30.bvh').getByRole('button').first().click();
  await app.tab('Doctor');
  await app.field('Frame rate').fill('24');
  await app.field('Frame rate').blur();
  await expect(app.row('walk-hik-30.bvh')).toContainText('24 Hz');
  await app.row('walk-hik-30.bvh').hover();
  await app.button('Remove walk-hik-30.bvh').click();
  await app.expectNames('walk-poser-30.bvh');
  await expect(app.openName).toHaveText('walk-poser-30.bvh');
  await page.locator('.toast').getByRole('button', { name: 'Undo' }).click();
  await app.expectNames('walk-hik-30.bvh', 'walk-poser-30.bvh');
  await expect(app.openName).toHaveText('walk-hik-30.bvh');
  await expect(app.row('walk-hik-30.bvh')).toContainText('24 Hz');
  await page.keyboard.press('Control+Shift+Z');
  await app.expectNames('walk-poser-30.bvh');

  await app.row('walk-poser-30.bvh').getByRole('button').first().press('Delete');
  await expect(app.rows).toHaveCount(0);
  await expect(
    page.getByRole('heading', {
      name: 'See the keyposes of a motion, and which motions are alike.',
    }),
  ).toBeVisible();
  await page.keyboard.press('Control+z');
  await app.expectNames('walk-poser-30.bvh');
  await app.tab('Method');
  await expect(app.section('Result')).toContainText('10 keyposes');
});

test('while a decision waits for the next one, the old result stays, dimmed', async ({
  app,
  page,
}) => {
  await page.clock.install();
  await app.openWith(...sampleFiles('walk-hik-60'));
  const result = app.section('Result');
  const before = await result.locator('.result').innerText();
  await app.tab('Doctor');
  await page.clock.pauseAt(Date.now() + 60_000);
  await app.field('Frame rate').fill('24');
  await app.field('Frame rate').blur();
  await page.clock.runFor(100);
  await page.getByRole('tab', { name: 'Method' }).click();
  await page.clock.runFor(20);
  await expect(result).toContainText('updating …');
  expect(await result.locator('.result').innerText()).toBe(before);
  await page.clock.resume();
  await expect(app.row('walk-hik-60.bvh')).toContainText('24 Hz');
  await expect(result).not.toContainText('updating …');
});
