/** A restless person: thousands of random presses, keys, drops and undos; nothing breaks, and all views agree. */
import { type Page, expect, test } from '@playwright/test';
import { findChromium, flatArguments } from '../../scripts/chromium.mjs';
import { AppPage } from '../e2e/support/app-page';
import { sampleFiles, temporaryFolder, tinyBvh, writeFiles } from '../e2e/support/motions';
import { serveApp } from '../support/app-page';
import type { StaticServer } from '../support/static-server';

const SECONDS = Number(process.env['KEYPOSE_RESTLESS_S'] ?? 120);
const SEED = Number(process.env['KEYPOSE_SEED'] ?? 1);

let served: StaticServer;

test.beforeAll(async () => {
  served = await serveApp();
});

test.afterAll(() => served.stop());

test.use({
  viewport: { width: 1440, height: 900 },
  locale: 'en-GB',
  launchOptions: { executablePath: findChromium(), args: flatArguments },
});

/** Numbers from 0 to 1, the same for a seed (xorshift of 32 bits). */
function randomFrom(seed: number): () => number {
  let state = seed >>> 0 || 1;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return (state >>> 0) / 2 ** 32;
  };
}

const keys =
  'k Shift+K Space ArrowLeft ArrowRight ArrowUp ArrowDown Home End [ ] l Delete Enter Shift+Enter + - 0 z Tab Shift+Tab PageDown F2 Control+End Control+z Control+Shift+Z Escape'.split(
    ' ',
  );
const pressable =
  '.page-tab, .clip-open, .clip-remove button, .matrix-name, .side-tabs .tab, .near-card, .neighbour, .error-row, .open-pair, .matrix-head button, .compare-bar button, .menu-item, .column-sort, .table-name, .table-tools button, .pair-bar button, .pair-transport button, .pair-clip, .pair-list-row, .pair-card, .map-area button, .language, .toast button, .label-form button, dialog button'.split(
    ', ',
  );
const surfaces = ['.matrix-grid', '.map-area', '.tree-cut', '.pair-area', '.confusion'];

/** What views show of one state, where they do not agree. */
const disagreements = (page: Page): Promise<string[]> =>
  page.evaluate(() => {
    const seen = (selector: string): HTMLElement[] =>
      [...document.querySelectorAll<HTMLElement>(selector)].filter((one) => one.checkVisibility());
    const found: string[] = [];
    const open = seen('.clip.open .clip-name').map((one) => one.title.replace(/\.bvh$/i, ''));
    const [named] = seen('.pair-name').map((one) => one.title);
    if (open.length > 1) found.push('two clips are open');
    if (named && open[0] && !open[0].endsWith(named)) found.push(`A is ${open[0]} and ${named}`);
    for (const rows of ['.matrix-name', '.side-table tr'])
      if (seen(`${rows}[aria-selected="true"]`).length > 2) found.push(`more than a pair: ${rows}`);
    const [cut] = seen('.tree-cut-handle');
    const value = (name: string): number => Number(cut?.getAttribute(`aria-value${name}`));
    if (cut && !(value('now') >= 1 && value('now') <= value('max'))) found.push('clusters > clips');
    const odd = /\b(undefined|NaN|\[object)\b/.exec(document.body.innerText);
    if (odd) found.push(`the text ${odd[0]}`);
    if (document.documentElement.scrollWidth > innerWidth) found.push('scrolls sideways');
    return found;
  });

test('nothing breaks, whatever is pressed', async ({ page }) => {
  const faults: string[] = [];
  page.on('pageerror', (error) => faults.push(error.message));
  page.on('console', (message) => {
    if (message.type() === 'error') faults.push(message.text());
  });
  page.on('dialog', () => faults.push('a dialog of the browser'));
  page.setDefaultTimeout(1_000);
  const random = randomFrom(SEED);
  const pick = <T>(from: readonly T[]): T => from[Math.floor(random() * from.length)];
  const app = new AppPage(page);
  const files = [
    ...sampleFiles('walk-hik-30', 'walk-poser-30', 'run-hik-30', 'run-vrm-30', 'slow-dance-hik-30'),
    ...writeFiles(temporaryFolder(), {
      'prop.bvh': tinyBvh(40),
      'pose.bvh': tinyBvh(1),
      'broken.bvh': 'no motion',
    }),
  ];
  const drop = () => app.drop(...files.filter(() => random() < 0.5));
  const press = async (): Promise<void> => {
    const all = page.locator(pick(pressable)).filter({ visible: true });
    const count = await all.count();
    if (count > 0) await all.nth(Math.floor(random() * count)).click({ force: true });
  };
  const point = async (): Promise<void> => {
    const box = await page.locator(pick(surfaces)).first().boundingBox();
    if (!box) return;
    const place = () => [box.x + random() * box.width, box.y + random() * box.height] as const;
    await page.mouse.move(...place());
    if (random() < 0.3) return page.mouse.wheel(0, 800 * (random() - 0.6));
    await page.mouse.down();
    if (random() < 0.5) await page.mouse.move(...place(), { steps: 4 });
    await page.mouse.up();
  };
  const write = async (): Promise<void> => {
    const all = page.locator('input[type="text"], input[type="search"]').filter({ visible: true });
    const count = await all.count();
    if (count === 0) return;
    const field = all.nth(Math.floor(random() * count));
    await field.fill(pick(['{label}-*', '{label}', '*{label}*', '', 'walk', '<b>', '20', '長い']));
    await field.press(pick(['Enter', 'Escape', 'Tab']));
  };
  const resize = () =>
    page.setViewportSize({ width: pick([320, 800, 1440, 1440]), height: pick([700, 900]) });
  const acts = [press, press, press, press, point, point, write, drop, resize];
  const done: string[] = [];

  await page.goto(`${served.address}?stage=off`, { timeout: 30_000 });
  await expect(page.locator('.top-bar')).toContainText('Keypose');
  await drop();
  const endMs = Date.now() + 1_000 * SECONDS;
  let count = 0;
  for (; Date.now() < endMs; count++) {
    const act = random() < 0.3 ? () => page.keyboard.press(pick(keys)) : pick(acts);
    done.push(act.name);
    // What is covered or has just gone cannot be pressed.
    await act().catch(() => undefined);
    if (count % 10 > 0) continue;
    await page.waitForTimeout(50);
    faults.push(...(await disagreements(page)));
    expect(faults, `after ${done.slice(-12).join(', ')}, seed ${SEED}`).toEqual([]);
  }
  process.stdout.write(`${count} acts\n`);
  await expect(page.locator('.progress-card, .comparing')).toHaveCount(0);
});
