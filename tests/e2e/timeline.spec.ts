/** The timeline: zoom, pan, overview, folding, hover, the loop and an hour of motion, by pointer and by key. */
import type { Page } from '@playwright/test';
import { longText, sampleFiles, temporaryFolder, tinyBvh, writeFiles } from './support/motions';
import { keyposeFramesOf, reportOf } from './support/reports';
import { expect, test } from './support/test';

/** Middles of the rows, from the upper edge of the timeline. */
const rulerY = 35;
const speedY = 75;
const scalesY = 140;

const sample = 'walk-hik-60';

const area = (page: Page) => page.locator('.timeline-area');
const overview = (page: Page) => page.getByRole('slider', { name: 'Overview' });
const spanText = (page: Page) => overview(page).getAttribute('aria-valuetext');

/** The seconds shown: from, to, of. */
async function shownSeconds(page: Page): Promise<number[]> {
  return [...((await spanText(page)) ?? '').matchAll(/[\d.,]+/g)].map(([text]) =>
    Number(text.replace(',', '')),
  );
}

async function boxOf(page: Page, selector = '.timeline-area') {
  return (await page.locator(selector).boundingBox())!;
}

/** Turns the wheel over the timeline, at a part of its width. */
async function wheel(page: Page, part: number, y: number, key: string, turns: number) {
  const { x, y: top, width } = await boxOf(page);
  await page.mouse.move(x + part * width, top + y);
  await page.keyboard.down(key);
  for (let n = 0; n < Math.abs(turns); n++) await page.mouse.wheel(0, 100 * Math.sign(turns));
  await page.keyboard.up(key);
}

async function drag(page: Page, from: [number, number], to: [number, number]) {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...to, { steps: 5 });
  await page.mouse.up();
}

test('the wheel zooms about the pointer and pans; playing and keys take the view along', async ({
  app,
  page,
}) => {
  const [path = ''] = sampleFiles(sample);
  const last = reportOf(path).frames - 1;
  await app.openWith(path);
  const whole = await spanText(page);
  await wheel(page, 0.5, speedY, 'Control', 0);
  const pointedS = async (): Promise<number> =>
    Number((await page.locator('.hover-flag').innerText()) || NaN);
  await expect.poll(pointedS).toBeGreaterThan(0);
  const before = await pointedS();
  await wheel(page, 0.5, speedY, 'Control', -6);
  await expect.poll(() => spanText(page)).not.toBe(whole);
  const [first = 0, end = 0] = await shownSeconds(page);
  expect(end - first).toBeLessThan(2);
  await wheel(page, 0.5, speedY + 1, 'Control', 0);
  await expect.poll(async () => Math.abs((await pointedS()) - before)).toBeLessThan(0.05);

  const zoomed = await spanText(page);
  await wheel(page, 0.5, speedY, 'Shift', 2);
  await expect.poll(() => spanText(page)).not.toBe(zoomed);
  await page.keyboard.press('End');
  await app.expectFrame(last);
  await expect.poll(async () => (await shownSeconds(page))[1]).toBeCloseTo(last / 60, 1);
  await page.keyboard.press('Home');
  await expect.poll(async () => (await shownSeconds(page))[0]).toBe(0);
  await page.keyboard.press(' ');
  await expect.poll(async () => (await shownSeconds(page))[0]).toBeGreaterThan(0.5);
  await page.keyboard.press(' ');
  await wheel(page, 0.5, speedY, 'Control', 30);
  await expect.poll(() => spanText(page)).toBe(whole);
});

test('the ruler has a tick for each frame at the closest', async ({ app, page }) => {
  await app.openWith(...sampleFiles(sample));
  await wheel(page, 0.5, speedY, 'Control', -40);
  await expect
    .poll(async () => {
      const [first = 0, end = 0] = await shownSeconds(page);
      return end - first;
    })
    .toBeLessThan(0.5);
  const labels = page.locator('.ruler-label:visible small');
  const frames = (await labels.allInnerTexts()).map(Number);
  expect(frames.length).toBeGreaterThan(3);
  const steps = frames.slice(1).map((frame, index) => frame - (frames[index] ?? 0));
  expect(Math.min(...steps)).toBeLessThanOrEqual(5);
});

test('the overview is a brush for pointer and keys', async ({ app, page }) => {
  await app.openWith(...sampleFiles(sample));
  const box = await boxOf(page, '.overview');
  const y = box.y + box.height / 2;
  const x = (part: number): number => box.x + part * box.width;
  const [, , length = 0] = await shownSeconds(page);
  await drag(page, [x(0.3), y], [x(0.6), y]);
  await expect.poll(async () => (await shownSeconds(page))[0]).toBeCloseTo(0.3 * length, 0);
  await drag(page, [x(0.45), y], [x(0.65), y]);
  const [first = 0, last = 0] = await shownSeconds(page);
  expect(first).toBeCloseTo(0.5 * length, 0);
  expect(last).toBeCloseTo(0.8 * length, 0);
  const window = (await page.locator('.overview-window').boundingBox())!;
  await drag(page, [window.x + window.width, y], [x(0.6), y]);
  await expect.poll(async () => (await shownSeconds(page))[1]).toBeCloseTo(0.6 * length, 0);
  expect((await shownSeconds(page))[0]).toBe(first);

  await overview(page).focus();
  for (let n = 0; n < 4; n++) await page.keyboard.press('ArrowLeft');
  await expect.poll(async () => (await shownSeconds(page))[0]).toBeLessThan(first);
  const [start = 0, end = 0] = await settledSeconds(page);
  for (let n = 0; n < 4; n++) await page.keyboard.press('Shift+ArrowRight');
  await expect.poll(async () => (await shownSeconds(page))[1]).toBeGreaterThan(end);
  expect((await shownSeconds(page))[0]).toBe(start);
  await page.keyboard.press('Home');
  await expect.poll(async () => (await shownSeconds(page))[0]).toBe(0);
  await page.mouse.dblclick(x(0.9), y);
  await expect.poll(async () => (await shownSeconds(page))[1]).toBe(length);
});

/** What is shown once every key that was pressed has been drawn. */
async function settledSeconds(page: Page): Promise<number[]> {
  let before: number[] = [];
  await expect(async () => {
    const last = before;
    before = await shownSeconds(page);
    expect(before).toEqual(last);
  }).toPass();
  return before;
}

test('rows fold, by pointer and by key, and stay so', async ({ app, page }) => {
  await app.openWith(...sampleFiles(sample));
  const height = async (): Promise<number> => (await boxOf(page, '.timeline')).height;
  const before = await height();
  const scales = page.getByRole('button', { name: 'Time scales' });
  await expect(scales).toHaveAttribute('aria-expanded', 'true');
  await scales.click();
  await expect(scales).toHaveAttribute('aria-expanded', 'false');
  await expect.poll(height).toBe(before - 50);
  await page.getByRole('button', { name: 'Speed', exact: true }).focus();
  await page.keyboard.press('Enter');
  await expect.poll(height).toBe(before - 50 - 36);
  await page.reload();
  await app.openWith(...sampleFiles(sample));
  await expect(scales).toHaveAttribute('aria-expanded', 'false');
  await scales.press(' ');
  await expect.poll(height).toBe(before - 36);
});

test('hovering shows the moment: anywhere, on a pin, on a trace', async ({ app, page }) => {
  const [path = ''] = sampleFiles(sample);
  const report = reportOf(path);
  await app.openWith(path);
  const { x, y, width } = await boxOf(page);
  const flag = page.locator('.hover-flag');
  const figure = page.locator('.row-figure').nth(1);
  const atPlayhead = await figure.innerText();
  await page.mouse.move(x + width * 0.4, y + speedY);
  await expect(flag).toBeVisible();
  await expect(figure).not.toHaveText(atPlayhead);
  const third = report.keyposes[2];
  await page.locator('.pin').nth(2).hover();
  await expect(flag).toHaveText(third.time_s.toFixed(3));
  const pin = (await page.locator('.pin').nth(2).boundingBox())!;
  await page.mouse.move(pin.x + pin.width / 2, y + scalesY - 28);
  await expect(flag).toHaveText(third.time_s.toFixed(3));
  await page.mouse.down();
  await page.mouse.up();
  await app.expectFrame(third.frame);
  await page.mouse.move(x + width / 2, y - 200);
  await expect(flag).toBeHidden();
});

test('a loop is dragged on the ruler, moved by its tabs and keys, and cleared', async ({
  app,
  page,
}) => {
  await app.openWith(...sampleFiles(sample));
  const { x, y, width } = await boxOf(page);
  const at = (part: number, row = rulerY): [number, number] => [x + part * width, y + row];
  await page.mouse.click(...at(0.25));
  await expect.poll(() => app.frame()).toBeGreaterThan(50);
  const sought = await app.frame();
  const band = page.locator('.loop-band');
  await expect(band).toBeHidden();
  await drag(page, at(0.4), at(0.6));
  await expect(band).toBeVisible();
  await app.expectFrame(sought);
  const tab = (name: RegExp) => page.getByRole('slider', { name });
  const [a, b] = [tab(/^A, /), tab(/^B, /)];
  const frameOf = async (end: typeof a): Promise<number> =>
    Number(await end.getAttribute('aria-valuenow'));
  const [first, last] = [await frameOf(a), await frameOf(b)];
  expect(last).toBeGreaterThan(first + 20);

  await b.focus();
  await page.keyboard.press('ArrowLeft');
  await expect.poll(() => frameOf(b)).toBe(last - 1);
  await page.keyboard.press('Shift+ArrowRight');
  await expect.poll(() => frameOf(b)).toBe(last + 5);
  await expect(b).toHaveAttribute('aria-valuetext', /seconds, frame \d+/);
  const grip = (await a.boundingBox())!;
  await drag(page, [grip.x + 5, grip.y + 8], at(0.5));
  await expect.poll(() => frameOf(a)).toBeGreaterThan(first + 10);

  await page.keyboard.press('l');
  await expect(band).toHaveClass(/off/);
  await page.keyboard.press('Escape');
  await expect(band).toBeHidden();
  await drag(page, at(0.7), at(0.8));
  await expect(band).toBeVisible();
  await page.mouse.dblclick(...at(0.75, speedY));
  await expect(band).toBeHidden();
});

test('pins that would touch share a lozenge, which opens; keys reach every keypose', async ({
  app,
  page,
}) => {
  const [path = ''] = writeFiles(temporaryFolder(), {
    'long.bvh': longText('walk-hik-30', 3_000_000),
  });
  const report = reportOf(path);
  const frames = keyposeFramesOf(report);
  await app.openWith(path);
  const lozenge = page.locator('.pin.several').first();
  await expect(lozenge).toHaveAccessibleName(/^Keyposes \d+ to \d+ of \d+: zoom in$/);
  const whole = await spanText(page);
  await lozenge.click();
  await expect.poll(() => spanText(page)).not.toBe(whole);
  await expect(page.locator('.pin:not(.several)').first()).toBeVisible();

  await page.keyboard.press('Home');
  await page.keyboard.press('k');
  await app.expectFrame(frames[0] ?? -1);
  const first = page.locator('.pin[aria-current]');
  await first.focus();
  for (const frame of frames.slice(1, 8)) {
    await page.keyboard.press('ArrowRight');
    await app.expectFrame(frame);
    await expect(page.locator('.pin[aria-current]')).toBeFocused();
  }
  await expect(page.locator('.pin[tabindex="0"]')).toHaveCount(1);
});

test('an hour of motion opens whole, and is zoomed into without a long task', async ({
  app,
  page,
}) => {
  test.slow();
  const [path = ''] = writeFiles(temporaryFolder(), { 'hour.bvh': hourBvh() });
  await app.openWith(path);
  await expect.poll(async () => (await shownSeconds(page))[2]).toBe(3600);
  expect(await page.locator('.timeline *').count()).toBeLessThan(400);
  await expect(page.locator('.ruler-label:visible').last()).toContainText(/:00/);
  await page.evaluate(() => {
    const seen: number[] = [];
    (window as unknown as { draws: number[] }).draws = seen;
    new PerformanceObserver((list) =>
      seen.push(...list.getEntries().map((e) => e.duration)),
    ).observe({ entryTypes: ['longtask'] });
  });
  await wheel(page, 0.5, speedY, 'Control', -20);
  await wheel(page, 0.5, speedY, 'Shift', 10);
  await expect.poll(async () => (await shownSeconds(page))[0]).toBeGreaterThan(1500);
  const tasks = await page.evaluate(() => (window as unknown as { draws: number[] }).draws);
  // Other programs share the machine: told, and held only against what would be felt.
  expect(Math.max(0, ...tasks)).toBeLessThan(500);
});

/** An hour at 10 frames per second of a body that swings its limbs. */
function hourBvh(): string {
  const frames = 36_001;
  const channels = 'CHANNELS 3 Zrotation Xrotation Yrotation';
  const limb = (name: string, x: number, y: number): string =>
    `JOINT ${name}\n{\nOFFSET ${x} ${y} 0\n${channels}\nEnd Site\n{\nOFFSET ${x} ${2 * y} 0\n}\n}`;
  const rows = Array.from({ length: frames }, (_, n) => {
    const swing = (phase: number): string => (40 * Math.sin(n / 9 + phase) ** 3).toFixed(3);
    return `0 0 0 0 0 0 ${swing(0)} 0 0 0 ${swing(1)} 0`;
  });
  return [
    'HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0',
    'CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation',
    `${limb('A', 10, 20)}\n${limb('B', -10, -20)}\n}`,
    `MOTION\nFrames: ${frames}\nFrame Time: 0.1\n${rows.join('\n')}\n`,
  ].join('\n');
}

test('a clip in which nothing moves says so; one without motion says that', async ({
  app,
  page,
}) => {
  const still = tinyBvh(30).replace(/^[-\d.]+( [-\d.]+){5}$/gm, '0 0 0 0 0 0');
  const skeleton = tinyBvh(0);
  const paths = writeFiles(temporaryFolder(), { 'still.bvh': still, 'skeleton.bvh': skeleton });
  await app.openWith(...paths);
  const reason = page.locator('.timeline-reason');
  await app.row('skeleton.bvh').click();
  await expect(reason).toContainText('only the skeleton is shown');
  await app.row('still.bvh').click();
  await expect(reason).toContainText('Nothing moves');
  await expect(page.locator('.ruler-label:visible').first()).toBeVisible();
  await expect(overview(page)).toBeVisible();
  await expect(area(page).locator('.pin')).toHaveCount(0);
});
