// A walk through all pages of the built app in Firefox and in WebKit, each skipped, saying so, where it is not
// installed. Its pictures lie in test-results/browsers.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, afterEach, beforeAll, describe, expect, test } from 'vitest';
import { sampleFiles, sampleText, sixSamples } from '../e2e/support/motions';
import { serveApp } from '../support/app-page';
import type { StaticServer } from '../support/static-server';
import { findFirefox, startFirefox } from './firefox';
import { findProgram } from './program';
import { type Driver, Session } from './session';
import { findWebKit, startWebKit } from './webkit';

const pictures = join(import.meta.dirname, '..', '..', 'test-results', 'browsers');
const set = sixSamples;
const input = 'input[type=file]:not([webkitdirectory])';

let server: StaticServer;
beforeAll(async () => {
  server = await serveApp();
});
afterAll(() => server.stop());

/** The program, null, saying so, where it or the screen that it draws on cannot be had. */
function present(name: string, program: string | null): string | null {
  const screen = process.platform !== 'linux' || findProgram('Xvfb') !== null;
  if (program && screen) return program;
  process.stderr.write(`skipped: no ${program ? 'Xvfb to draw on' : name}\n`);
  return null;
}

function walk(name: string, program: string | null, start: (program: string) => Promise<Driver>) {
  describe.skipIf(program === null)(name, () => {
    let page: Session;
    beforeAll(async () => {
      page = new Session(await start(program ?? ''));
    });
    afterAll(() => page.close());
    /** The page as a person sees it now. */
    const keep = async (step: string): Promise<void> => {
      mkdirSync(pictures, { recursive: true });
      writeFileSync(join(pictures, `${name}-${step}.png`), await page.picture());
    };

    afterEach(async ({ task }) => {
      if (task.result?.state === 'fail') await keep('failed').catch(() => undefined);
    });

    test('a sample opens from the empty page, is drawn and plays', async () => {
      await page.open(server.address);
      await page.until('what the four samples hold', () => {
        const told = [...document.querySelectorAll('.sample-about')];
        return told.length === 4 && told.every(({ textContent }) => textContent !== '');
      });
      await keep('empty');
      await page.click('.sample-open');
      await page.until('the stage', () => document.querySelector('#stage-figure canvas') !== null);
      await page.until('the strip', () => document.querySelectorAll('.keypose-card').length === 13);
      await page.press('Home');
      await page.press(' ');
      const frame = () =>
        Number(/\d+/.exec(document.querySelector('.clock-frame')!.textContent)?.[0]);
      await page.until('a later frame', frame);
      await page.press(' ');
      await keep('study');
      expect(await page.faults()).toEqual([]);
    });

    test('files, chosen and dropped, are studied and exported; words change', async () => {
      await page.open(`${server.address}?stage=off`);
      await page.give(input, sampleFiles('walk-hik-30'));
      await page.until('the walk', clipsRead, 1);
      await page.run(drop, 'run.bvh', sampleText('run-hik-30'));
      await page.until('the run', clipsRead, 2);
      expect(await page.text('.top-clip .clip-name')).toBe('run.bvh');
      await page.click('[role=tab]', 'Export');
      await page.click('[role=tabpanel] button', 'CSV');
      await page.until('a file', () => document.querySelector('.toast-text') !== null);
      expect((await page.saved()).map((file) => file.name)).toEqual(['run.keyposes.csv']);
      await page.click('.top-bar button', '日本語');
      await page.until('Japanese', () => document.documentElement.lang === 'ja');
      await page.open(`${server.address}?stage=off`);
      await page.until('Japanese again', () => document.documentElement.lang === 'ja');
      await page.click('.top-bar button', 'English');
      await page.until('English', () => document.documentElement.lang === 'en');
      expect(await page.faults()).toEqual([]);
    });

    test('a set is compared: matrix, tree, map, labels, scores, files', async () => {
      await page.open(`${server.address}?stage=off`);
      await page.give(input, sampleFiles(...set));
      await page.until('the clips', clipsRead, set.length);
      await page.click('.page-tab', 'Compare');
      await page.until('the comparison', () => !!document.querySelector('.compare.compared'));
      await page.until('figures on the map', () => !!document.querySelector('.map-figure path'));
      await page.run(() => document.querySelector<HTMLElement>('.compare [role=slider]')?.focus());
      await page.press('End');
      await expect.poll(() => page.text('.compare [role=slider]'), wait).toBe('6 clusters');
      await page.run(() => document.querySelector<HTMLElement>('[role=gridcell]')?.focus());
      for (const key of ['Control+Home', 'ArrowRight', ' ']) await page.press(key);
      await page.until('the reasons', () => document.querySelector('.distance-sentence b'));
      await page.click('.compare-bar button', 'Labels');
      await page.click('[role=menuitemradio]', 'from file name');
      await page.until('the pattern', () => document.activeElement?.matches('[popover] input'));
      for (const key of ['Control+a', ...'{label}-*', 'Enter']) await page.press(key);
      await page.until('the scores', () => !!document.querySelector('.confusion'));
      await keep('compare');
      for (const item of ['Matrix (NumPy)', 'Matrix (SVG)', 'Map (PNG)']) {
        const before = (await page.saved()).length;
        await page.click('.compare-bar button', 'Export');
        await page.click('[role=menuitem]', item);
        await expect.poll(async () => (await page.saved()).length, wait).toBe(before + 1);
      }
      const heads = (await page.saved()).map(({ name, head }) => `${name} ${head.slice(1, 4)}`);
      expect(heads).toEqual(['distances.npy NUM', 'matrix.svg svg', 'map.png PNG']);
      expect(await page.faults()).toEqual([]);
    });

    test('a pair is drawn, warped, laid over each other and filmed', async () => {
      await page.open(server.address);
      await page.give(input, sampleFiles('walk-hik-30', 'run-hik-30'));
      await page.until('the clips', clipsRead, 2);
      await page.click('.page-tab', 'Pair');
      await page.until('the stages', () => document.querySelectorAll('.pair-stage canvas').length);
      await page.click('#pair button', 'Time warp');
      await page.until('the distance', () => document.querySelector('.distance-sentence b'));
      await keep('pair');
      await page.click('#pair button', 'Superposed');
      await page.click('#pair button', 'Start');
      for (const key of ['Home', '[', 'ArrowRight', 'ArrowRight', ']']) await page.press(key);
      await keep('superposed');
      const canFilm = await page.run(() => typeof VideoEncoder === 'function');
      const disabled = () => document.querySelector<HTMLButtonElement>('#film-button')?.disabled;
      expect(await page.run(disabled)).toBe(!canFilm);
      if (canFilm) await film(page);
      expect(await page.faults()).toEqual([]);
    });
  });
}

const wait = { timeout: 60_000, interval: 200 };

/** A film that the browser itself can play. */
async function film(page: Session): Promise<void> {
  await page.click('#film-button');
  await page.click('[popover] button', 'Save film');
  await expect.poll(async () => (await page.saved())[0]?.type, wait).toBe('video/webm');
  const played = await page.run(async () => {
    const video = document.createElement('video');
    video.src = URL.createObjectURL(window.watched!.saved[0].file!);
    await new Promise((resolve, reject) => {
      video.onloadeddata = resolve;
      video.onerror = () => reject(new Error(video.error?.message));
    });
    return { width: video.videoWidth, height: video.videoHeight, lengthS: video.duration };
  });
  expect(played).toMatchObject({ width: 1280, height: 720 });
  expect(played.lengthS).toBeCloseTo(0.1, 2);
}

/** Runs in the page: everything has been read, and there are so many clips. */
function clipsRead(count: number): boolean {
  const busy = document.querySelector('.progress-card, .clip progress, .outdated');
  return busy === null && document.querySelectorAll('.clip').length === count;
}

/** Runs in the page: a file comes over it and is let go. */
function drop(name: string, text: string): void {
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([text], name));
  for (const type of ['dragenter', 'dragover', 'drop'])
    document.body.dispatchEvent(
      new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer }),
    );
}

walk('Firefox', present('Firefox (FIREFOX_PATH)', findFirefox()), startFirefox);
walk('WebKit', present('WebKitWebDriver (WEBKIT_DRIVER_PATH)', findWebKit()), startWebKit);
