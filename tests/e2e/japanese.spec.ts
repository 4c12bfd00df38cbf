/** Japanese throughout: what can be read or heard on the main views holds no English. */
import type { Page } from '@playwright/test';
import { sampleFiles, temporaryFolder, withShortRow, writeFiles } from './support/motions';
import { expect, test } from './support/test';

/** Names, units and terms that are the same in both languages. */
const same = [
  /\bkeypose\b/gi,
  /\b(BVH|CSV|JSON|CMU|ANOVA|OFFSET|CHANNELS|ROOT|HIERARCHY|MOTION|GitHub)\b/g,
  /\bMiura et al\. 2014\b/g,
  /\b(Ward|Mojena)\b/g,
  /--(csv|json|candidates|traces)\b/g,
  /\bkeyposes\b/g,
  /\b(English|Home|End|Shift|Ctrl|Delete|Esc|Enter|Space)\b/g,
  /\b(Hz|kB|MB|cm|mm|dm)\b/g,
  /stage=off/g,
  /\S+\.(bvh|zip|txt)\b/gi,
];

/** Every text that is seen, and every name, hint and tip. */
async function texts(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    // Names from the file itself.
    const names =
      '.joints td:not(.joint-source), .clip-name, .fact dd[lang], script, style, [hidden] *';
    const found: string[] = [];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_ALL);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      const element = node instanceof Element ? node : node.parentElement;
      if (!element || element.matches('[hidden]') || element.closest(names)) continue;
      if (node instanceof Text) found.push(node.data.trim());
      if (!(node instanceof Element)) continue;
      for (const name of [
        'aria-label',
        'title',
        'placeholder',
        'data-tip',
        'alt',
        'aria-valuetext',
      ])
        found.push(node.getAttribute(name) ?? '');
    }
    return [...new Set([...found, document.title])].filter(Boolean);
  });
}

/** Texts with an English word in them. */
async function english(page: Page, ...names: string[]): Promise<string[]> {
  return (await texts(page)).filter((text) => {
    const rest = [...same, ...names.map((name) => new RegExp(name, 'g'))].reduce(
      (left, pattern) => left.replace(pattern, ''),
      text,
    );
    return /[A-Za-z]{3,}/.test(rest);
  });
}

async function expectNoEnglish(page: Page, ...names: string[]): Promise<void> {
  expect(await english(page, ...names)).toEqual([]);
}

test('the switch turns every view to Japanese and back, and stays', async ({ app, page }) => {
  await app.open();
  await expect(page.locator('html')).toHaveAttribute('lang', 'en');
  expect((await english(page)).length).toBeGreaterThan(10);
  await page.getByRole('button', { name: '日本語' }).click();
  await expect(page.locator('html')).toHaveAttribute('lang', 'ja');
  await expect(page.getByRole('heading', { level: 1 })).toHaveText(
    '動きのキーポーズと、似た動きが見える。',
  );
  await expect(page.locator('.sample-open')).toHaveCount(4);
  await expectNoEnglish(page);

  const broken = writeFiles(temporaryFolder(), { 'broken.bvh': withShortRow('walk-hik-30').text });
  await app.drop(...sampleFiles('slow-dance-vrm-30', 'walk-poser-30'), ...broken);
  await app.settled();
  await expect(page.locator('.clip.ready')).toHaveCount(2);
  for (const tab of ['手法', '体', '書き出し', '点検']) {
    await app.tab(tab);
    await expectNoEnglish(page);
  }
  await app.row('walk-poser-30.bvh').getByRole('button').first().click();
  await page.locator('#leading-frames').fill('5');
  await page.locator('#leading-frames').blur();
  await app.settled();
  await expectNoEnglish(page);
  await app.row('broken.bvh').getByRole('button').first().click();
  await expect(page.getByRole('alert')).toContainText('このファイルは読み込めませんでした');
  await expectNoEnglish(page);
  await page.keyboard.press('?');
  await expect(page.getByRole('dialog', { name: 'キーボード操作' })).toBeVisible();
  await expectNoEnglish(page);
  await page.keyboard.press('Escape');

  await page.reload();
  await expect(page.locator('html')).toHaveAttribute('lang', 'ja');
  await page.getByRole('button', { name: 'English' }).click();
  await expect(page.locator('html')).toHaveAttribute('lang', 'en');
});

test.describe('a Japanese browser', () => {
  test.use({ locale: 'ja-JP' });
  test('fetches English words when English is chosen, and shows none before', async ({
    app,
    page,
  }) => {
    const books: string[] = [];
    page.on('request', (request) => {
      const book = /book-(en|ja)/.exec(request.url());
      if (book?.[1]) books.push(book[1]);
    });
    await app.open();
    await expect(page.locator('html')).toHaveAttribute('lang', 'ja');
    await expect(page.locator('.sample-open')).toHaveCount(4);
    expect(books).toEqual(['ja']);
    // A slow network: the page stays Japanese, and whole, until all of English is there.
    let release: () => void = () => undefined;
    const held = new Promise<void>((done) => {
      release = done;
    });
    await page.route(/book-en/, async (route) => {
      await held;
      await route.continue();
    });
    await page.getByRole('button', { name: 'English' }).click();
    await expect.poll(() => books).toEqual(['ja', 'en']);
    await expectNoEnglish(page);
    release();
    await expect(page.locator('html')).toHaveAttribute('lang', 'en');
    await expect(page.getByRole('heading', { level: 1 })).toContainText('See the keyposes');
  });

  test('is met in Japanese', async ({ app, page }) => {
    await app.openWith(...sampleFiles('walk-hik-30'));
    await expect(page.locator('html')).toHaveAttribute('lang', 'ja');
    await expect(app.caption).toContainText('キーポーズ 1 / 10');
    await expect(app.section('結果')).toContainText('キーポーズ 10 個');
  });
});
