// Accessibility as axe-core judges it (WCAG 2.2 A and AA): the empty page and a study, light and dark.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { expect, type Page, test } from '@playwright/test';
import type { AxeResults } from 'axe-core';

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

for (const colorScheme of ['light', 'dark'] as const) {
  test.describe(colorScheme, () => {
    test.use({ colorScheme });

    test('the empty page breaks no rule', async ({ page }) => {
      await page.goto('/?stage=off', { waitUntil: 'networkidle' });
      expect(await faults(page)).toEqual([]);
    });

    test('a study breaks no rule', async ({ page }) => {
      await page.goto('/?stage=off', { waitUntil: 'networkidle' });
      await page.locator('.sample-open').first().click();
      await page.getByRole('slider').first().waitFor();
      expect(await faults(page)).toEqual([]);
    });
  });
}
