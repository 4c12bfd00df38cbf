/** The stage as it is drawn: ghosts, trails, performers, full screen, and what it says where it cannot draw. */
import type { Locator, Page } from '@playwright/test';
import type { AppPage } from './support/app-page';
import { watchDrawing } from './support/drawn';
import {
  sampleFiles,
  temporaryFolder,
  tinyBvh,
  withTwoPerformers,
  writeFiles,
} from './support/motions';
import { expect, test } from './support/test';

// Drawn by software: a small stage, and time.
test.use({ viewport: { width: 1040, height: 600 }, deviceScaleFactor: 1 });
test.setTimeout(120_000);

const tags = (page: Page): Locator => page.locator('.stage-tag:visible');

async function openDrawn(app: AppPage, ...paths: string[]): Promise<void> {
  await app.open('');
  await app.drop(...paths);
  await app.settled();
  await expect(app.page.locator('.stage-canvas')).toBeVisible();
}

test('ghosts stand at the neighbouring keyposes, with their numbers, until they are turned off', async ({
  app,
  page,
}) => {
  const drawn = await watchDrawing(page);
  await openDrawn(app, ...sampleFiles('slow-dance-hik-30'));
  for (let i = 0; i < 3; i++) await page.keyboard.press('k');
  await expect.poll(async () => (await tags(page).allInnerTexts()).sort()).toEqual(['2', '3', '4']);
  await expect(page.locator('.stage-tag.current:visible')).toHaveText('3');
  const boxes = await tags(page).evaluateAll((all) =>
    all.map((tag) => tag.getBoundingClientRect().toJSON() as DOMRect),
  );
  for (const [i, a] of boxes.entries()) {
    for (const b of boxes.slice(i + 1)) {
      const beside = a.right <= b.left || b.right <= a.left;
      expect(beside || a.bottom <= b.top || b.bottom <= a.top).toBe(true);
    }
  }
  const withGhosts = (await drawn()).calls;
  await app.button('Ghosts').click();
  await expect(app.button('Ghosts')).toHaveAttribute('aria-pressed', 'false');
  await expect(tags(page)).toHaveCount(0);
  // Each of two ghosts for its depth and for its colour.
  await expect.poll(async () => withGhosts - (await drawn()).calls).toBe(4);
});

test('trails of joints are chosen by a list, with the keyboard alone', async ({ app, page }) => {
  const drawn = await watchDrawing(page);
  await openDrawn(app, ...sampleFiles('slow-dance-hik-30'));
  await page.keyboard.press('k');
  await page.keyboard.press('k');
  await expect(tags(page)).toHaveCount(3);
  await app.button('Joints with trails').focus();
  await page.keyboard.press('Enter');
  const item = (name: string): Locator => page.getByRole('menuitemcheckbox', { name });
  const found = await page.getByRole('menuitemcheckbox', { checked: true }).allInnerTexts();
  expect(found.map((name) => name.trim().split(' ')[1]).sort()).toEqual(['ankle', 'wrist']);
  await expect.poll(async () => (await drawn()).calls).toBe(8);
  const before = (await drawn()).triangles.reduce((a, b) => a + b, 0);
  const other = item(
    found.some((name) => name.includes('Left wrist')) ? 'Right wrist' : 'Left wrist',
  );
  await other.focus();
  await page.keyboard.press('Enter');
  await expect(other).toHaveAttribute('aria-checked', 'true');
  await expect
    .poll(async () => (await drawn()).triangles.reduce((a, b) => a + b, 0))
    .toBeGreaterThan(before);
  expect((await drawn()).calls).toBe(8);
  await page.keyboard.press('Escape');
  await app.button('Trails').click();
  await expect.poll(async () => (await drawn()).calls).toBe(7);
});

test('a press on a bone draws its joint’s trail; a drag turns the figure instead', async ({
  app,
  page,
}) => {
  await openDrawn(app, ...sampleFiles('slow-dance-hik-30'));
  await page.keyboard.press('k');
  await expect(tags(page).first()).toBeVisible();
  const { x, y, name } = await placeOnFigure(page);
  const joints = async (): Promise<string[]> => {
    await app.button('Joints with trails').click();
    const checked = page.getByRole('menuitemcheckbox', { checked: true });
    await expect(checked.first()).toBeVisible();
    const names = (await checked.allInnerTexts()).map((text) => text.trim());
    await page.keyboard.press('Escape');
    return names.sort();
  };
  const before = await joints();
  await page.mouse.click(x, y);
  const others = before.filter((joint) => joint !== name);
  const after = (before.includes(name) ? others : [...before, name]).sort();
  // The menu tells of the press once it has been drawn anew.
  await expect.poll(joints).toEqual(after);
  await expect(app.button('Side')).toHaveAttribute('aria-pressed', 'true');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y, { steps: 4 });
  await page.mouse.up();
  await expect(app.button('Side')).toHaveAttribute('aria-pressed', 'false');
  expect(await joints()).toEqual(after);
});

/** A place where the pointer meets a bone for good, and the name that it says there. */
async function placeOnFigure(page: Page): Promise<{ x: number; y: number; name: string }> {
  const box = (await page.locator('.stage-canvas').boundingBox())!;
  const tip = page.locator('.stage-tip');
  const x = box.x + box.width / 2;
  const highest = box.y + box.height * 0.3;
  let y = highest;
  let name = '';
  await expect(async () => {
    y = y > box.y + box.height * 0.75 ? highest : y + 5;
    await page.mouse.move(x, y);
    await expect(tip).toBeVisible({ timeout: 300 });
    name = await tip.innerText();
    await page.waitForTimeout(500);
    await page.mouse.move(x + 0.5, y);
    await expect(tip).toHaveText(name, { timeout: 100 });
  }).toPass();
  return { x, y, name };
}

test('the keyboard turns the camera on the stage, and steps frames elsewhere', async ({
  app,
  page,
}) => {
  await openDrawn(app, ...sampleFiles('walk-hik-30'));
  await page.keyboard.press('ArrowRight');
  await app.expectFrame(1);
  await page.locator('.stage-canvas').focus();
  await page.keyboard.press('ArrowRight');
  await expect(app.button('Side')).toHaveAttribute('aria-pressed', 'false');
  await app.expectFrame(1);
  await page.keyboard.press('k');
  await expect.poll(() => app.frame()).toBeGreaterThan(1);
  await app.button('Front').click();
  await expect(app.button('Front')).toHaveAttribute('aria-pressed', 'true');
  await app.button('Turn by a quarter').click();
  await expect(app.button('Front')).toHaveAttribute('aria-pressed', 'false');
});

test('of several performers one is chosen, by its letter; the caption names it', async ({
  app,
  page,
}) => {
  const [path = ''] = writeFiles(temporaryFolder(), {
    'two.bvh': withTwoPerformers('walk-hik-30'),
  });
  await openDrawn(app, path);
  await page.keyboard.press('k');
  await expect(app.caption).toContainText('A · Keypose 1 of');
  await expect(app.button('Performer A')).toHaveAttribute('aria-pressed', 'true');
  await app.button('Performer B').click();
  await expect(app.caption).toContainText('B · Keypose');
  await expect(app.button('Performer B')).toHaveAttribute('aria-pressed', 'true');
  await expect(page.locator('#spoken-caption')).toContainText('Performer B');
});

test('a stage keeps to its budget, and draws nothing while nothing changes', async ({
  app,
  page,
}) => {
  const drawn = await watchDrawing(page);
  await openDrawn(app, ...sampleFiles('slow-dance-hik-30'));
  await page.keyboard.press('k');
  await page.keyboard.press('k');
  await expect(tags(page)).toHaveCount(3);
  await cameraAtRest(page);
  const { calls, triangles, frames, uniformVectors } = await drawn();
  expect(calls).toBeLessThanOrEqual(30);
  // Background and ground are two triangles at most; figure and ghosts are the rest, besides trails.
  const figures = triangles.filter((count) => count > 2);
  expect(figures.length).toBeGreaterThanOrEqual(5);
  for (const count of figures) expect(count).toBeLessThanOrEqual(3000);
  expect(uniformVectors).toBeGreaterThan(10);
  expect(uniformVectors).toBeLessThanOrEqual(200);
  await page.evaluate(async () => {
    for (let i = 0; i < 60; i++) await new Promise(requestAnimationFrame);
  });
  expect((await drawn()).frames).toBe(frames);
});

/** The browser has shown thirty frames in a row without the stage's drawing: by its own time, however slow it is. */
async function cameraAtRest(page: Page): Promise<void> {
  await page.evaluate(async () => {
    const { drawn } = window as unknown as { drawn: { frames: number } };
    for (let still = 0, frames = -1; still < 30; still++) {
      if (drawn.frames !== frames) still = 0;
      frames = drawn.frames;
      await new Promise(requestAnimationFrame);
    }
  });
}

test('F shows stage, transport and timeline alone, and the same key leaves', async ({
  app,
  page,
}) => {
  await app.openWith(...sampleFiles('walk-hik-30'));
  await page.keyboard.press('f');
  await expect(page.locator('.top-bar')).toBeHidden();
  await expect(page.locator('.library')).toBeHidden();
  for (const part of ['.stage', '.transport', '.timeline-place'])
    await expect(page.locator(part)).toBeVisible();
  await expect.poll(() => page.evaluate(() => document.fullscreenElement !== null)).toBe(true);
  await expect(app.button('Leave full screen')).toBeVisible();
  await page.keyboard.press('f');
  await expect(page.locator('.top-bar')).toBeVisible();
  await expect.poll(() => page.evaluate(() => document.fullscreenElement !== null)).toBe(false);
});

test('without a full screen the window is filled, until Escape', async ({ app, page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(Document.prototype, 'fullscreenEnabled', { get: () => false });
  });
  await app.openWith(...sampleFiles('walk-hik-30'));
  await app.button('Full screen').click();
  await expect(page.locator('.top-bar')).toBeHidden();
  await page.keyboard.press('Escape');
  await expect(page.locator('.top-bar')).toBeVisible();
});

test('a lost context is told, the rest goes on, and the figure comes back', async ({
  app,
  page,
  faults,
}) => {
  await openDrawn(app, ...sampleFiles('walk-hik-30'));
  await page.evaluate(() => {
    const canvas = document.querySelector<HTMLCanvasElement>('.stage-canvas')!;
    const loss = canvas.getContext('webgl2')!.getExtension('WEBGL_lose_context')!;
    Object.assign(window, { loss });
    loss.loseContext();
  });
  const sentence = page.locator('.stage-sentence');
  await expect(sentence).toContainText('The browser took the graphics away');
  await page.keyboard.press('k');
  await expect.poll(() => app.frame()).toBeGreaterThan(0);
  const drawn = page.waitForFunction(() => {
    const canvas = document.querySelector<HTMLCanvasElement>('.stage-canvas')!;
    return !canvas.getContext('webgl2')!.isContextLost();
  });
  await page.evaluate(() =>
    (window as unknown as { loss: { restoreContext(): void } }).loss.restoreContext(),
  );
  await drawn;
  await expect(sentence).toHaveCount(0);
  await expect(app.button('Ghosts')).toBeVisible();
  expect(await inkOf(page)).toBeGreaterThan(0.003);
  // three.js tells the console of the loss.
  faults.length = 0;
});

/** Part of the stage's picture that is strongly coloured: a figure is there. */
async function inkOf(page: Page): Promise<number> {
  const picture = await page.locator('.stage-canvas').screenshot();
  return page.evaluate(
    async (bytes) => {
      const image = await createImageBitmap(new Blob([Uint8Array.from(bytes)]));
      const context = new OffscreenCanvas(image.width, image.height).getContext('2d')!;
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height);
      let coloured = 0;
      for (let i = 0; i < data.length; i += 4) {
        const colour = [data[i] ?? 0, data[i + 1] ?? 0, data[i + 2] ?? 0];
        if (Math.max(...colour) - Math.min(...colour) > 80) coloured++;
      }
      return coloured / (data.length / 4);
    },
    [...picture],
  );
}

test('without WebGL 2 a sentence says so, and the rest goes on', async ({ app, page }) => {
  await page.addInitScript(() => {
    const prototype = HTMLCanvasElement.prototype as unknown as Record<string, unknown>;
    const own = prototype['getContext'] as (...values: unknown[]) => unknown;
    prototype['getContext'] = function (this: HTMLCanvasElement, ...values: unknown[]): unknown {
      return values[0] === 'webgl2' ? null : Reflect.apply(own, this, values);
    };
  });
  await app.open('');
  await app.drop(...sampleFiles('walk-hik-30'));
  await app.settled();
  await expect(page.locator('.stage-sentence')).toContainText('offers no WebGL 2');
  await expect(app.button('Ghosts')).toHaveCount(0);
  await page.keyboard.press('k');
  await expect(app.caption).toContainText('Keypose 1 of');
});

test('a stage that could not be loaded says so, and can be loaded again', async ({
  app,
  page,
  faults,
}) => {
  const isStage = /\/assets\/stage-[^/]*\.js/;
  await page.route(isStage, (route) => route.abort());
  await app.open('');
  await app.drop(...sampleFiles('walk-hik-30'));
  await app.settled();
  await expect(page.locator('.stage-sentence')).toContainText('could not be loaded');
  await page.keyboard.press('k');
  await expect(app.caption).toContainText('Keypose 1 of');
  await page.unroute(isStage);
  await app.button('Load it again').click();
  await expect(app.button('Ghosts')).toBeVisible();
  await expect(page.locator('.stage-sentence')).toHaveCount(0);
  faults.length = 0;
});

test('a frame with values beyond all places says so; the next one is drawn', async ({
  app,
  page,
}) => {
  const lines = tinyBvh(40).split('\n');
  const at = lines.findIndex((line) => line.startsWith('Frame Time')) + 1;
  for (let n = 0; n < 20; n++) lines[at + n] = '1e308 0 0 0 0 0';
  const [path = ''] = writeFiles(temporaryFolder(), { 'far.bvh': lines.join('\n') });
  await openDrawn(app, path);
  await expect(page.locator('.stage-sentence')).toContainText('no place that can be drawn');
  await page.keyboard.press('End');
  await expect(page.locator('.stage-sentence')).toHaveCount(0);
});
