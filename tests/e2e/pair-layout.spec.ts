/** The page Pair at the widths of desks, tablets and phones, in both languages: nothing is cut or covered. */
import type { Page } from '@playwright/test';
import { sampleText, temporaryFolder, writeFiles } from './support/motions';
import { expect, test } from './support/test';

/** What is cut off or lies over something else, of the controls of the page. */
function crowded(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const found: string[] = [];
    const nameOf = (node: Element): string => `${node.className}: ${node.textContent?.trim()}`;
    const shown = (selector: string): Element[] =>
      [...document.querySelectorAll(selector)].filter((node) => node.getClientRects().length > 0);
    for (const row of ['.pair-choice', '.pair-bar', '.pair-transport']) {
      const parts = shown(`${row} > :not(.rule, [popover], .pair-bar-gap)`);
      const boxes = parts.map((node) => node.getBoundingClientRect());
      boxes.forEach((a, i) => {
        if (a.left < 0 || a.right > innerWidth) found.push(`outside ${nameOf(parts[i])}`);
        boxes.slice(i + 1).forEach((b, j) => {
          const apart =
            a.right <= b.left + 0.5 ||
            b.right <= a.left + 0.5 ||
            a.bottom <= b.top + 0.5 ||
            b.bottom <= a.top + 0.5;
          if (!apart) found.push(`over ${nameOf(parts[i])} ${nameOf(parts[i + j + 1])}`);
        });
      });
      for (const node of shown(`${row} :is(button, .pair-clip-name, .segments)`))
        if (node.scrollWidth > node.clientWidth) found.push(`cut ${nameOf(node)}`);
    }
    return found;
  });
}

for (const locale of ['en-GB', 'ja-JP']) {
  test.describe(`in ${locale}`, () => {
    test.use({ locale });
    for (const [width, height] of [
      [1440, 900],
      [1024, 768],
      [768, 1024],
      [390, 844],
    ] as const)
      test(`nothing is cut or covered at a width of ${width}`, async ({ app, page }) => {
        await page.setViewportSize({ width, height });
        const text = sampleText('walk-hik-30');
        const files = writeFiles(temporaryFolder(), { '07_11.bvh': text, '07_04.bvh': text });
        await app.open('?stage=off');
        await app.drop(...files);
        await app.settled();
        await page.locator('.page-tab').nth(2).click();
        await expect(page.locator('.pair-ahead')).toHaveCount(2);
        expect(await crowded(page)).toEqual([]);
      });
  });
}
