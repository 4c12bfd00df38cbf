/** The pair as film: a WebM by time, not by screen; its length, size and moments; cancelled; where no encoder is. */
import { readFileSync } from 'node:fs';
import type { Download, Page } from '@playwright/test';
import type { AppPage } from './support/app-page';
import { sampleFiles } from './support/motions';
import { expect, test } from './support/test';

const walk = 'walk-hik-30';
const run = 'run-hik-30';

/** What makes films is fetched with the first one. */
const told = { timeout: 60_000 };

/** A short stretch of the pair, in frames of A. */
async function openStretch(app: AppPage, frames: number): Promise<void> {
  const { page } = app;
  await app.openWith(...sampleFiles(walk, run));
  await page.locator('.page-tab', { hasText: 'Pair' }).click();
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  for (const key of ['Home', '[', ...Array<string>(frames).fill('ArrowRight'), ']'])
    await page.keyboard.press(key);
}

const film = (page: Page) => page.locator('#film-button');
const panel = (page: Page) => page.getByRole('dialog', { name: 'Pair as film' });
const choose = (page: Page, name: string) =>
  panel(page).getByRole('button', { name, exact: true }).click();

async function save(page: Page): Promise<void> {
  await choose(page, 'Save film');
  await expect(panel(page)).toBeHidden();
}

async function made(page: Page): Promise<Download> {
  const download = page.waitForEvent('download', { timeout: 200_000 });
  await save(page);
  return download;
}

/** From now on as a tab behind others is: no frames, timers once a second. Returns what shows it again. */
async function hide(page: Page): Promise<() => Promise<void>> {
  await page.evaluate(() => {
    const frame = requestAnimationFrame.bind(window);
    const timer = setTimeout.bind(window);
    const waiting: FrameRequestCallback[] = [];
    Object.defineProperty(document, 'hidden', { configurable: true, value: true });
    const slow = (task: () => void, ms = 0) => timer(task, Math.max(1000, ms));
    const never = (draw: FrameRequestCallback) => waiting.push(draw);
    Object.assign(window, { requestAnimationFrame: never, setTimeout: slow });
    const show = () => {
      Reflect.deleteProperty(document, 'hidden');
      Object.assign(window, { requestAnimationFrame: frame, setTimeout: timer });
      waiting.forEach((draw) => frame(draw));
    };
    Object.assign(window, { show });
  });
  return () => page.evaluate(() => (window as unknown as { show: () => void }).show());
}

interface Played {
  readonly lengthS: number;
  readonly width: number;
  readonly height: number;
  /** How much the picture in the middle differs from the first, of 255 at every pixel. */
  readonly differs: number;
}

/** Plays a film in a page of its own. */
async function play(page: Page, bytes: Buffer): Promise<Played> {
  const other = await page.context().newPage();
  const played = await other.evaluate(async (text) => {
    const own = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const video = document.createElement('video');
    video.src = URL.createObjectURL(new Blob([own], { type: 'video/webm' }));
    await new Promise((resolve, reject) => {
      video.onloadeddata = resolve;
      video.onerror = () => reject(new Error(video.error?.message));
    });
    const { videoWidth: width, videoHeight: height, duration: lengthS } = video;
    const context = new OffscreenCanvas(width, height).getContext('2d')!;
    const pixels = async (timeS: number) => {
      const there = new Promise((resolve) => (video.onseeked = resolve));
      video.currentTime = timeS;
      await there;
      context.drawImage(video, 0, 0);
      return context.getImageData(0, 0, width, height).data;
    };
    const first = await pixels(0.001);
    const middle = await pixels(lengthS / 2);
    const sum = first.reduce((all, value, i) => all + Math.abs(value - middle[i]), 0);
    return { lengthS, width, height, differs: sum / first.length };
  }, bytes.toString('base64'));
  await other.close();
  return played;
}

test('a film made in a hidden tab plays: as long, as large and as moved as it should be', async ({
  app,
  page,
}) => {
  test.setTimeout(300_000);
  await openStretch(app, 6);
  await film(page).focus();
  await page.keyboard.press('Enter');
  await expect(panel(page)).toContainText('0.23 s · 7 frames');
  await expect(panel(page)).toContainText('A–B, 0.00 to 0.20 s');
  await page.keyboard.press('Escape');
  await expect(panel(page)).toBeHidden();
  await expect(film(page)).toBeFocused();
  await page.keyboard.press('Enter');
  await choose(page, '25');
  await expect(panel(page)).toContainText('0.24 s · 6 frames');
  const saved = page.waitForEvent('download', { timeout: 200_000 });
  await save(page);
  await expect(film(page)).toBeFocused();
  const show = await hide(page);
  const download = await saved;
  await show();
  expect(download.suggestedFilename()).toBe(`${walk} with ${run}.webm`);
  await expect(app.toast).toHaveText(`${walk} with ${run}.webm saved`);
  await expect(film(page)).toHaveText('Film');
  const bytes = readFileSync(await download.path());
  expect(bytes.subarray(0, 4).toString('hex')).toBe('1a45dfa3');
  const { lengthS, width, height, differs } = await play(page, bytes);
  expect([width, height]).toEqual([1280, 720]);
  expect(lengthS).toBeCloseTo(0.24, 3);
  expect(differs).toBeGreaterThan(0.2);
});

/** Tells how many of the page's WebGL contexts are in use. */
async function watchGraphics(page: Page): Promise<() => Promise<number>> {
  await page.addInitScript(() => {
    const contexts = new Set<WebGL2RenderingContext>();
    Object.assign(window, { contexts });
    const own = Object.getOwnPropertyDescriptor(HTMLCanvasElement.prototype, 'getContext')!;
    Object.defineProperty(HTMLCanvasElement.prototype, 'getContext', {
      value(this: HTMLCanvasElement, ...values: unknown[]) {
        const context: unknown = Reflect.apply(own.value as () => unknown, this, values);
        if (context instanceof WebGL2RenderingContext) contexts.add(context);
        return context;
      },
    });
  });
  return () =>
    page.evaluate(() => {
      const { contexts } = window as unknown as { contexts: Set<WebGL2RenderingContext> };
      return [...contexts].filter((context) => !context.isContextLost()).length;
    });
}

/** Tells of every picture that goes into the encoder: when it is, and what is on it. */
async function watchPictures(page: Page): Promise<() => Promise<[time: number, hash: number][]>> {
  await page.addInitScript(() => {
    const pictures: [number, number][] = [];
    Object.assign(window, { pictures });
    const own = Object.getOwnPropertyDescriptor(VideoEncoder.prototype, 'encode')!;
    VideoEncoder.prototype.encode = function (frame, options) {
      const { displayWidth: width, displayHeight: height } = frame;
      const context = new OffscreenCanvas(width, height).getContext('2d')!;
      context.drawImage(frame, 0, 0);
      const { data } = context.getImageData(0, 0, width, height);
      const hash = data.reduce((all, value) => (Math.imul(all, 31) + value) | 0, 7);
      pictures.push([frame.timestamp, hash]);
      Reflect.apply(own.value as VideoEncoder['encode'], this, [frame, options]);
    };
  });
  return () =>
    page.evaluate(() => (window as unknown as { pictures: [number, number][] }).pictures.splice(0));
}

test('its pictures go by time: the same in another window and while the pair plays', async ({
  app,
  page,
}) => {
  test.setTimeout(300_000);
  const pictures = await watchPictures(page);
  const graphics = await watchGraphics(page);
  await openStretch(app, 2);
  const before = await graphics();
  await film(page).click();
  await made(page);
  await expect.poll(graphics).toBe(before);
  const once = await pictures();
  expect(once.map(([time]) => time)).toEqual([0, 33_333, 66_667]);
  expect(new Set(once.map(([, hash]) => hash)).size).toBe(3);
  await page.setViewportSize({ width: 1100, height: 700 });
  await page.keyboard.press('Escape');
  await film(page).click();
  const download = page.waitForEvent('download', { timeout: 200_000 });
  await save(page);
  await page.keyboard.press('Space');
  await download;
  expect(await pictures()).toEqual(once);
});

test('a cancelled film leaves no file and a page that goes on', async ({ app, page }) => {
  test.setTimeout(180_000);
  await openStretch(app, 20);
  let files = 0;
  page.on('download', () => files++);
  await film(page).click();
  await choose(page, '60');
  await save(page);
  await expect(film(page)).toHaveText('Cancel the film');
  await expect(page.locator('.film-count')).toHaveText(/^Frame [1-9]\d* of 41$/);
  await film(page).click();
  await expect(film(page)).toHaveText('Film');
  await expect(page.locator('.film-progress')).toHaveCount(0);
  await page.keyboard.press('Home');
  await page.keyboard.press('ArrowRight');
  await expect(page.locator('.pair-clock .clock-time').first()).toHaveText('0.03');
  await page.waitForTimeout(1000);
  expect(files).toBe(0);
  await expect(app.toast).toHaveCount(0);
});

test('what keeps a film from being made is told, with what to do', async ({ app, page }) => {
  test.setTimeout(120_000);
  await openStretch(app, 3);
  await page.evaluate(() => {
    VideoEncoder.isConfigSupported = () => Promise.resolve({ supported: false });
  });
  await film(page).click();
  await save(page);
  await expect(app.toast).toContainText('choose the smaller one, or another browser', told);
  await expect(film(page)).toHaveText('Film');
  await page.evaluate(() => {
    VideoEncoder.isConfigSupported = () => Promise.resolve({ supported: true });
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await film(page).click();
  await save(page);
  await expect(app.toast).toContainText('close other pages that draw, then try again', told);
});

/** Of the film's panel and of its button. */
async function boxes(page: Page) {
  const [over, button] = [await panel(page).boundingBox(), await film(page).boundingBox()];
  if (!over || !button) throw new Error('the panel is not open');
  const { width, height } = page.viewportSize()!;
  const inWindow =
    over.x >= 0 && over.y >= 0 && over.x + over.width <= width && over.y + over.height <= height;
  return { inWindow, apart: Math.round(button.y - over.y - over.height) };
}

test('the panel stands over its button whenever its content comes, and goes with the window', async ({
  app,
  page,
}) => {
  await openStretch(app, 2);
  await page.evaluate(() => {
    // So slow that every view has a frame of its own; other views come first.
    const own = performance.now.bind(performance);
    let more = 0;
    performance.now = () => own() + (more += 10);
    document.body.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft', bubbles: true }));
    document.getElementById('film-button')!.click();
  });
  await expect(panel(page).getByRole('button', { name: 'Save film' })).toBeVisible();
  const right = { inWindow: true, apart: 4 };
  expect(await boxes(page)).toEqual(right);
  await page.setViewportSize({ width: 1100, height: 640 });
  await expect.poll(() => boxes(page)).toEqual(right);
  await film(page).click();
  await expect(panel(page)).toBeHidden();
});

test('a browser without an encoder says so', async ({ app, page }) => {
  await page.addInitScript(() => {
    delete (window as { VideoEncoder?: unknown }).VideoEncoder;
  });
  await app.openWith(...sampleFiles(walk, run));
  await page.locator('.page-tab', { hasText: 'Pair' }).click();
  await expect(film(page)).toBeDisabled();
  await expect(film(page)).toHaveAccessibleDescription(/This browser cannot encode films/);
});
