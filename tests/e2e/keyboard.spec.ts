/** The whole page without a pointer: every control is reached by Tab, and its ring is seen. */
import { reach } from './support/by-keys';
import { expect, test } from './support/test';

test('open, play, step, loop, zoom, set a parameter, export, sort, help, all by keys', async ({
  app,
  page,
}) => {
  test.setTimeout(120_000);
  await app.open();
  await reach(page, page.locator('.sample-open').nth(1));
  await page.keyboard.press('Enter');
  await app.settled();
  const press = async (...keys: string[]): Promise<void> => {
    for (const key of keys) await page.keyboard.press(key);
  };

  await test.step('the transport, by its buttons', async () => {
    await reach(page, app.button('Play'));
    await press('Enter');
    await expect.poll(() => app.frame()).toBeGreaterThan(3);
    await press('Enter');
    await expect(app.button('Play')).toBeFocused();
    await press('Home');
    await app.expectFrame(0);
    await reach(page, app.button('One frame on'));
    await press(' ');
    await app.expectFrame(1);
    await reach(page, app.button('Next keypose'));
    await press('Enter');
    await expect(app.caption).toContainText('Keypose 1 of');
    await press('[', 'k', 'k', ']');
    await reach(page, page.locator('.loop'));
    await expect(page.locator('.loop')).toHaveAttribute('aria-pressed', 'true');
    await press('Enter');
    await expect(page.locator('.loop')).toHaveAttribute('aria-pressed', 'false');
    await reach(page, app.button('Clear A–B'));
    await press('Enter');
    await expect(page.locator('.loop')).toHaveText('Loop');
    await reach(page, app.button('Zoom in'));
    await press('Enter', 'Enter');
    await reach(page, app.button('Show the whole clip'));
    await press('Enter');
    await expect(app.button('Show the whole clip')).toBeDisabled();
  });

  await test.step('strip and timeline: one stop each for cards, pins and playhead', async () => {
    await reach(page, page.locator('.keypose-card.current'));
    await press('ArrowRight');
    await expect(page.locator('.keypose-card.current')).toBeFocused();
    await reach(page, app.section('Timeline').getByRole('slider', { name: 'Playhead' }));
    const before = await app.frame();
    await press('ArrowRight');
    await app.expectFrame(before + 1);
  });

  await test.step('a parameter and an export', async () => {
    await reach(page, page.locator('#inspector [role="tab"][aria-selected="true"]'));
    const field = page.locator('#inspector input').first();
    await reach(page, field);
    await press('Control+a');
    await page.keyboard.type('4');
    await press('Enter');
    await app.settled();
    const reset = page.getByRole('button', { name: /^Back to the default 10: Low-pass/ });
    await expect(reset).toBeVisible();
    await reach(page, reset, 'Shift+Tab');
    await press('Enter');
    await app.settled();
    await expect(reset).toHaveCount(0);
    await expect(field).toHaveValue('10');
    await reach(page, page.locator('#inspector [role="tab"][aria-selected="true"]'), 'Shift+Tab');
    await press('End');
    const download = page.waitForEvent('download');
    await reach(page, page.locator('#inspector .export button').first());
    await press('Enter');
    expect((await download).suggestedFilename()).toMatch(/\.keyposes\.csv$/);
  });

  await test.step('library, language and help', async () => {
    await reach(page, app.button('Sort'));
    await press('Enter');
    await expect(page.getByRole('menuitemradio', { name: 'Order of arrival' })).toBeFocused();
    await press('Escape');
    await press('?');
    await expect(page.getByRole('dialog', { name: 'Keyboard shortcuts' })).toBeVisible();
    await press('Escape');
    await reach(page, page.getByRole('button', { name: '日本語' }));
    await press('Enter');
    await expect(page.locator('html')).toHaveAttribute('lang', 'ja');
  });
});
