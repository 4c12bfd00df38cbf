/** The keyboard moves the time, as the list of keys says. */
import { sampleFiles } from './support/motions';
import { keyposeFramesOf, reportOf } from './support/reports';
import { expect, test } from './support/test';

test('keys step, jump, end and change the speed', async ({ app, page }) => {
  const [path = ''] = sampleFiles('walk-hik-60');
  const report = reportOf(path);
  const frames = keyposeFramesOf(report);
  const last = report.frames - 1;
  const press = async (key: string, frame: number): Promise<void> => {
    await page.keyboard.press(key);
    await app.expectFrame(frame);
  };
  await app.openWith(path);
  await press('Home', 0);
  await press('ArrowRight', 1);
  await press('ArrowRight', 2);
  await press('ArrowLeft', 1);
  await press('Shift+ArrowRight', 7);
  await press('Shift+ArrowLeft', 1);

  for (const frame of frames.slice(0, 3)) await press('k', frame);
  await expect(app.caption).toContainText(`Keypose 3 of ${frames.length}`);
  await press('Shift+K', frames[1] ?? -1);
  await press('ArrowRight', (frames[1] ?? 0) + 1);
  await expect(app.caption).toContainText(`Keypose 2 of ${frames.length}`);
  await expect(app.caption).toContainText('0.02 s past it');
  await press('Shift+K', frames[1] ?? -1);

  await press('End', last);
  await expect(page.locator('.clock-time')).toHaveText((last * report.frame_time_s).toFixed(3));
  await press('k', last);
  await press('Shift+K', frames.at(-1) ?? -1);
  await press('Home', 0);
  await press('Shift+K', 0);
  await press('ArrowLeft', 0);
});

test('Space plays to the end and pauses; speed and loop are shown', async ({ app, page }) => {
  await app.openWith(...sampleFiles('walk-hik-30'));
  const speed = page.locator('[popovertarget="speed-menu"]');
  await expect(speed).toHaveText('1×');
  for (const key of ['-', '-']) await page.keyboard.press(key);
  await expect(speed).toHaveText('0.5×');
  for (let n = 0; n < 9; n++) await page.keyboard.press('-');
  await expect(speed).toHaveText('0.1×');
  for (let n = 0; n < 9; n++) await page.keyboard.press('+');
  await expect(speed).toHaveText('4×');

  await page.keyboard.press('Home');
  await page.keyboard.press(' ');
  await expect(app.button('Pause')).toBeVisible();
  await expect.poll(() => app.frame()).toBeGreaterThan(20);
  await page.keyboard.press(' ');
  await expect(app.button('Play')).toBeVisible();
  const paused = await app.frame();
  await page.waitForTimeout(200);
  expect(await app.frame()).toBe(paused);

  const loop = app.button('Loop');
  await page.keyboard.press('l');
  await expect(loop).toHaveAttribute('aria-pressed', 'true');
  await page.keyboard.press('l');
  await page.keyboard.press(' ');
  await expect(app.button('Play')).toBeVisible();
  await app.expectFrame(Number(await page.locator('.playhead').getAttribute('aria-valuemax')));
});

test('[ and ] set A and B, L turns the loop on and off, Shift+L clears it', async ({
  app,
  page,
}) => {
  const [path = ''] = sampleFiles('walk-hik-60');
  const { frame_time_s } = reportOf(path);
  await app.openWith(path);
  const loop = page.locator('.loop');
  await page.keyboard.press('Home');
  const a = 30;
  const b = 48;
  for (let n = 0; n < 5; n++) await page.keyboard.press('Shift+ArrowRight');
  await app.expectFrame(a);
  await page.keyboard.press('[');
  await expect(loop).toHaveAttribute('aria-pressed', 'true');
  for (let n = 0; n < 3; n++) await page.keyboard.press('Shift+ArrowRight');
  await app.expectFrame(b);
  await page.keyboard.press(']');
  const seconds = (frame: number): string => (frame * frame_time_s).toFixed(2);
  await expect(loop).toHaveText(new RegExp(`A–B\\s*${seconds(a)}–${seconds(b)} s`));

  // From behind B it starts at A, and never leaves the loop.
  await page.keyboard.press('End');
  await page.keyboard.press(' ');
  await expect.poll(() => app.frame()).toBeLessThanOrEqual(b);
  for (let n = 0; n < 12; n++) {
    await page.waitForTimeout(50);
    const frame = await app.frame();
    expect(frame).toBeGreaterThanOrEqual(a);
    expect(frame).toBeLessThanOrEqual(b);
  }
  await page.keyboard.press(' ');
  await page.keyboard.press('l');
  await expect(loop).toHaveAttribute('aria-pressed', 'false');
  await expect(loop).toContainText('A–B');
  await page.keyboard.press('Shift+L');
  await expect(loop).toHaveText('Loop');
});

test('the speed can be chosen from a list, and the time stays', async ({ app, page }) => {
  await app.openWith(...sampleFiles('walk-hik-30'));
  await page.keyboard.press('k');
  await expect.poll(() => app.frame()).toBeGreaterThan(0);
  const frame = await app.frame();
  const speed = page.locator('[popovertarget="speed-menu"]');
  await expect(speed).toHaveAccessibleName('Speed 1×');
  await speed.focus();
  await page.keyboard.press('Enter');
  await expect(page.getByRole('menuitemradio', { name: '1×', exact: true })).toBeFocused();
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Enter');
  await expect(speed).toHaveText('0.75×');
  await expect(page.locator('#speed-menu')).toBeHidden();
  await app.expectFrame(frame);
});

test('? shows the list; keys are still while it is open, and in fields', async ({ app, page }) => {
  await app.openWith(...sampleFiles('walk-hik-30'));
  await page.keyboard.press('Home');
  await page.keyboard.press('?');
  const list = page.getByRole('dialog', { name: 'Keyboard shortcuts' });
  await expect(list).toContainText('Next keypose, previous with Shift');
  await expect(list).toContainText(/Ctrl\s*A\s*Select all/);
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Escape');
  await expect(list).toBeHidden();
  await app.expectFrame(0);

  await page.keyboard.press('/');
  const filter = app.field('Filter by name or label');
  await expect(filter).toBeFocused();
  await page.keyboard.type('walk k?');
  await expect(filter).toHaveValue('walk k?');
  await expect(list).toBeHidden();
  await app.expectFrame(0);
  await page.keyboard.press('Escape');
  await expect(filter).toHaveValue('');
});

test('timeline and strip: pins, cards and the playhead go where they are pressed', async ({
  app,
  page,
}) => {
  const [path = ''] = sampleFiles('walk-hik-60');
  const report = reportOf(path);
  const frames = keyposeFramesOf(report);
  await app.openWith(path);
  const count = frames.length;
  const timeline = app.section('Timeline');
  const nameOf = (number: number): string =>
    `Keypose ${number} of ${count}, ${report.keyposes[number - 1]?.time_s.toFixed(2)} seconds`;
  await timeline.getByRole('button', { name: nameOf(4), exact: true }).click();
  await app.expectFrame(frames[3] ?? -1);
  const strip = app.section('Keyposes');
  await expect(strip.locator('.keypose-card')).toHaveCount(count);
  await expect(strip.locator('.keypose-card svg > *').first()).toBeAttached();
  await strip.locator('.keypose-card').nth(1).click();
  await app.expectFrame(frames[1] ?? -1);
  await page.keyboard.press('ArrowRight');
  await app.expectFrame(frames[2] ?? -1);

  const area = (await timeline.locator('.timeline-area').boundingBox())!;
  const speedY = area.y + 80;
  await page.mouse.click(area.x + area.width - 10, speedY);
  await expect.poll(() => app.frame()).toBeGreaterThan(report.frames - 10);
  await page.mouse.move(area.x + area.width / 2, speedY);
  await page.mouse.down();
  await page.mouse.move(area.x + 2, speedY, { steps: 4 });
  await page.mouse.up();
  await expect.poll(() => app.frame()).toBeLessThan(4);
});
