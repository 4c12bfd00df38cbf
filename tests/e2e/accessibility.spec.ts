// Accessibility as axe-core judges it (WCAG 2.2 A and AA): the empty page, a study with
// every tab, drawers and dialogs, clips compared and side by side, light and dark, in both languages.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { expect, type Page, test } from '@playwright/test';
import type { AxeResults } from 'axe-core';
import { sampleFiles } from './support/motions';

// Evaluated, not inserted: the page's policy allows no script of another's.
const axeSource = readFileSync(createRequire(import.meta.url).resolve('axe-core'), 'utf8');
const tags = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa'];

/** A card shows its number and its time; its name says both, but with words between: "Keypose 1 of 13, 1.18 s". */
const allowed = { rule: 'label-content-name-mismatch', element: 'keypose-card' };

/** One line for every element that breaks a rule. */
async function faults(page: Page): Promise<string[]> {
  await page.evaluate(axeSource);
  const options = JSON.stringify({ runOnly: { type: 'tag', values: tags } });
  const results = await page.evaluate<AxeResults>(`axe.run(document, ${options})`);
  return results.violations.flatMap(({ id, help, nodes }) =>
    nodes
      .filter(({ html }) => !(id === allowed.rule && html.includes(allowed.element)))
      .map(({ target }) => `${id}: ${help}: ${target.join(' ')}`),
  );
}

/** A study at rest: the sample is read, its figures stand. */
async function openSample(page: Page): Promise<void> {
  await page.goto('/?stage=off', { waitUntil: 'networkidle' });
  await page.locator('.sample-open').first().click();
  await page.locator('.keypose-card .figure').first().waitFor();
}

/** Four motions of two kinds. */
const compared = (): string[] =>
  sampleFiles('walk-hik-30', 'walk-vrm-60', 'run-hik-30', 'run-vrm-60');

// Colours are those of the theme, words those of the language: two of the four together look at all.
for (const [colorScheme, locale] of [
  ['light', 'en-GB'],
  ['dark', 'ja-JP'],
] as const) {
  test.describe(`${colorScheme}, ${locale}`, () => {
    test.use({ colorScheme, locale });

    test('the empty page breaks no rule', async ({ page }) => {
      await page.goto('/?stage=off', { waitUntil: 'networkidle' });
      expect(await faults(page)).toEqual([]);
    });

    test('a study breaks no rule, with every tab, the loop, the list of keys and a menu', async ({
      page,
    }) => {
      test.setTimeout(240_000);
      await openSample(page);
      for (const key of ['Home', '[', 'k', 'k', ']', 'z']) await page.keyboard.press(key);
      const tabs = page.locator('#inspector [role="tab"]');
      const count = await tabs.count();
      for (let index = 0; index < count; index++) {
        await tabs.nth(index).click();
        expect(await faults(page)).toEqual([]);
      }
      await page.locator('[popovertarget="speed-menu"]').click();
      expect(await faults(page)).toEqual([]);
      await page.keyboard.press('Escape');
      await page.keyboard.press('?');
      expect(await faults(page)).toEqual([]);
    });

    test('Compare and Pair break no rule, with every tab and the labels from file names', async ({
      page,
    }) => {
      test.setTimeout(240_000);
      await page.goto('/?stage=off', { waitUntil: 'networkidle' });
      await page.locator('input[type="file"]').first().setInputFiles(compared());
      await page.locator('.page-tab').nth(1).click();
      await page.locator('#compare-side [role="tab"]').first().waitFor();
      await page.getByRole('gridcell').first().waitFor();
      await page.locator('[popovertarget="labels-menu"]').click();
      expect(await faults(page)).toEqual([]);
      await page.keyboard.press('Escape');
      const tabs = page.locator('#compare-side [role="tab"]');
      for (let index = 0; index < (await tabs.count()); index++) {
        await tabs.nth(index).click();
        expect(await faults(page)).toEqual([]);
      }
      await page.locator('.page-tab').nth(2).click();
      await page.locator('.pair-card').first().waitFor();
      expect(await faults(page)).toEqual([]);
      await page.locator('#film-button').click();
      await page.locator('.film-facts').waitFor();
      expect(await faults(page)).toEqual([]);
    });

    test('drawers break no rule', async ({ page }) => {
      test.setTimeout(120_000);
      await page.setViewportSize({ width: 800, height: 600 });
      await openSample(page);
      for (const panel of ['panel-left', 'panel-right']) {
        await page.locator(`.top-bar .icon-button:has(.icon-${panel})`).click();
        await page.locator('.drawer:visible').waitFor();
        expect(await faults(page)).toEqual([]);
        await page.keyboard.press('Escape');
      }
    });
  });
}
