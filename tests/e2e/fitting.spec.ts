/** Windows that are small, zoomed, touched or of forced colours: names whole, targets large, states seen. */
import type { Page } from '@playwright/test';
import { sampleFiles } from './support/motions';
import { expect, test } from './support/test';

const files = sampleFiles('walk-hik-30', 'walk-poser-30');
const tab = (page: Page, index: number) => page.locator('.page-tab').nth(index);

/** What the style sheets make of an element. */
const styleOf = (page: Page, selector: string, names: readonly string[]): Promise<string[]> =>
  page
    .locator(selector)
    .first()
    .evaluate((element, all) => {
      const style = getComputedStyle(element);
      return all.map((name) => style.getPropertyValue(name));
    }, names);

type Points = readonly (readonly [number, number])[];

/** Fingers of a real screen, as the browser meets them. */
async function fingers(page: Page) {
  const session = await page.context().newCDPSession(page);
  const send = (type: 'touchStart' | 'touchMove' | 'touchEnd', points: Points) =>
    session.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: points.map(([x, y], id) => ({ x, y, id })),
    });
  const drag = async (from: Points, to: Points): Promise<void> => {
    await send('touchStart', from);
    for (let n = 1; n <= 8; n++)
      await send(
        'touchMove',
        from.map(([x, y], k) => [x + ((to[k][0] - x) * n) / 8, y + ((to[k][1] - y) * n) / 8]),
      );
    await send('touchEnd', []);
  };
  return { send, drag };
}

test('720 wide, as a page at 200 %: the name of the open clip is whole', async ({ app, page }) => {
  await page.setViewportSize({ width: 720, height: 450 });
  await app.openWith(...files);
  const cut = await app.openName.evaluate((name) =>
    [...name.children].some((half) => half.scrollWidth > half.clientWidth + 1),
  );
  expect(cut).toBe(false);
  await app.button('Language, theme, help').click();
  await expect(page.getByRole('menuitem', { name: '日本語' })).toBeVisible();
});

test('1024 wide: the transport names the last frame', async ({ app, page }) => {
  await page.setViewportSize({ width: 1024, height: 768 });
  await app.openWith(...files);
  await expect(page.locator('.clock-last')).toBeVisible();
});

test('the look of a page does not depend on which were seen before', async ({ app, page }) => {
  await app.openWith(...files);
  const looks = async (): Promise<string[]> => {
    const segments = ['.matrix-head .segments', '.matrix-head .segments > .on'];
    const names = ['background-color', 'box-shadow', 'height', 'padding'];
    const all = await Promise.all(segments.map((one) => styleOf(page, one, names)));
    return all.flat();
  };
  const legend = ['flex-wrap', 'margin-top', 'white-space'];
  await tab(page, 1).click();
  const compare = await looks();
  expect(await styleOf(page, '.matrix-head .legend', legend)).toEqual(['nowrap', '0px', 'nowrap']);
  await tab(page, 2).click();
  await expect(page.locator('.pair-bar')).toBeVisible();
  await tab(page, 1).click();
  expect(await looks()).toEqual(compare);
});

test('forced colours: what is on is seen, and pins are', async ({ app, page }) => {
  await page.emulateMedia({ forcedColors: 'active' });
  await app.openWith(...files);
  await tab(page, 2).click();
  await expect(page.locator('.pair-pins .pin').first()).toBeVisible();
  const [on, off] = await Promise.all(
    ['.pair-bar .segments > .on', '.pair-bar .segments > :not(.on)'].map((one) =>
      styleOf(page, one, ['background-color']),
    ),
  );
  expect(on).not.toEqual(off);
  const disc = await page
    .locator('.pair-pins .pin')
    .first()
    .evaluate((pin) => getComputedStyle(pin, '::before').backgroundColor);
  expect([disc]).not.toEqual(await styleOf(page, '.pair-page', ['background-color']));
});

test.describe('with fingers', () => {
  test.use({ hasTouch: true, isMobile: true, viewport: { width: 390, height: 844 } });

  test('buttons are 44 px high and wide', async ({ app, page }) => {
    await app.openWith(...files);
    const small = await page
      .locator('.top-bar .icon-button, .transport :is(.button, .icon-button)')
      .filter({ visible: true })
      .evaluateAll((all) =>
        all.flatMap((one): string[] => {
          const { width, height } = one.getBoundingClientRect();
          return width < 44 || height < 44 ? [one.textContent + one.outerHTML.slice(0, 90)] : [];
        }),
      );
    expect(small).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  });

  test('a swipe and a pinch over the timeline leave the moment; a tap and a drag move it', async ({
    app,
    page,
  }) => {
    await app.openWith(...files);
    const box = (await page.locator('.timeline-area').boundingBox())!;
    const [x, y] = [box.x + 130, box.y + 90];
    const touch = await fingers(page);
    await touch.drag([[x, y]], [[x, y - 60]]);
    await app.expectFrame(0);
    const pair = (apart: number) => [[x - apart, y - 60] as const, [x + apart, y - 60] as const];
    await touch.drag(pair(20), pair(80));
    await expect(page.getByRole('slider', { name: 'Overview' })).toHaveAttribute(
      'aria-valuetext',
      /^[1-9]|^0\.[1-9]/,
    );
    await app.expectFrame(0);
    await page.touchscreen.tap(x, y - 60);
    await expect.poll(() => app.frame()).toBeGreaterThan(0);
    const tapped = await app.frame();
    await touch.drag([[x, y - 60]], [[x + 40, y - 60]]);
    await expect.poll(() => app.frame()).toBeGreaterThan(tapped);
  });

  test('a swipe over the rows of a pair leaves the moment; a tap and a drag move it', async ({
    app,
    page,
  }) => {
    await app.openWith(...files);
    await tab(page, 2).click();
    /** On A's speed. */
    const place = async (): Promise<[number, number]> => {
      const box = (await page.locator('.pair-area').boundingBox())!;
      return [box.x + 200, box.y + 110];
    };
    const [x, y] = await place();
    const clock = page.locator('.pair-clock .clock-time').first();
    const before = await clock.innerText();
    const touch = await fingers(page);
    await touch.drag([[x, y]], [[x, y - 60]]);
    await expect(clock).toHaveText(before);
    const [, there] = await place();
    expect(there).toBeLessThan(y);
    await page.touchscreen.tap(x, there);
    await expect(clock).not.toHaveText(before);
    const tapped = Number(await clock.innerText());
    await touch.drag([[x, there]], [[x + 30, there]]);
    await expect.poll(async () => Number(await clock.innerText())).toBeGreaterThan(tapped);
  });

  test('a long press on an icon names it', async ({ app, page }) => {
    await app.openWith(...files);
    const box = (await app.button('Next keypose').boundingBox())!;
    const touch = await fingers(page);
    await touch.send('touchStart', [[box.x + 10, box.y + 10]]);
    await expect(page.locator('.tip', { hasText: 'Next keypose' })).toBeVisible();
    await touch.send('touchEnd', []);
    await expect(page.locator('.tip', { hasText: 'Next keypose' })).toBeHidden();
  });
});
