// A control reached as by a person without a pointer. In: a page and a control. Out: it has the focus, seen.
import { type Locator, type Page, expect } from '@playwright/test';

/** Presses Tab until the control has the focus, which must then be seen: by its ring, or by what is drawn for it. */
export async function reach(
  page: Page,
  control: Locator,
  key = 'Tab',
  drawn?: Locator,
): Promise<void> {
  await control.waitFor();
  for (let n = 0; n < 200; n++) {
    const focused = await control.evaluate((element) => element === document.activeElement);
    if (focused && drawn) return expect(drawn).toBeVisible();
    if (focused) return expect.poll(() => hasRing(control)).toBe(true);
    await page.keyboard.press(key);
  }
  throw new Error(`${String(control)} is not reached by ${key}`);
}

/** An outline on the control, on what holds it, as for fields, or within it, as for the flag of the playhead. */
const hasRing = (control: Locator): Promise<boolean> =>
  control.evaluate((element) =>
    [element, ...element.querySelectorAll('*'), element.parentElement!].some((one) => {
      const { outlineStyle, outlineWidth } = getComputedStyle(one);
      return outlineStyle !== 'none' && parseFloat(outlineWidth) >= 2;
    }),
  );
