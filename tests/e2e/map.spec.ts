/** The map of a set that changes: what arrives is there at once, what is there stays. */
import type { Page } from '@playwright/test';
import type { AppPage } from './support/app-page';
import { changeOf, mapPoint, placesOnMap } from './support/map';
import { sampleFiles, sixSamples as set } from './support/motions';
import { expect, test } from './support/test';

const names = (page: Page) =>
  page.getByRole('listbox', { name: 'Clips in the order of the matrix' }).getByRole('option');

async function openCompare(app: AppPage, page: Page, ...clips: string[]): Promise<void> {
  await app.openWith(...sampleFiles(...clips));
  await page.getByRole('button', { name: 'Compare', exact: true }).click();
  await expect(names(page)).toHaveCount(clips.length);
}

/** From now on a comparison begins only when it is let go. */
async function holdComparisons(page: Page): Promise<() => Promise<void>> {
  await page.addInitScript(() => {
    const held: (() => void)[] = [];
    const holding = { now: false };
    const original = Reflect.get(Worker.prototype, 'postMessage') as (...given: unknown[]) => void;
    const send = (worker: Worker, given: unknown[]): void => Reflect.apply(original, worker, given);
    Worker.prototype.postMessage = function (this: Worker, ...given: unknown[]): void {
      const message = given[0] as { path?: string[] };
      if (holding.now && message.path?.[0] === 'compare') held.push(() => send(this, given));
      else send(this, given);
    };
    Object.assign(window, {
      holdComparisons: (): void => void (holding.now = true),
      letComparisonsGo: (): void => {
        holding.now = false;
        for (const go of held.splice(0)) go();
      },
    });
  });
  return async () => page.evaluate('letComparisonsGo()');
}

/** Nothing glides any more. */
async function stillMap(page: Page): Promise<void> {
  await page.waitForTimeout(600);
}

test('a clip that is added or removed leaves the others where they are', async ({ app, page }) => {
  await openCompare(app, page, ...set);
  await stillMap(page);
  const before = await placesOnMap(page);
  await app.drop(...sampleFiles('walk-vrm-60'));
  await expect(names(page)).toHaveCount(set.length + 1);
  await stillMap(page);
  const added = changeOf(before, await placesOnMap(page));
  expect(added).toMatchObject({ clips: set.length, isMirrored: false });
  expect(Math.abs(added.turnedDegrees)).toBeLessThan(2);

  const more = await placesOnMap(page);
  await app.row('run-poser-30.bvh').getByRole('button').first().click();
  await page.keyboard.press('Delete');
  await expect(names(page)).toHaveCount(set.length);
  await stillMap(page);
  const removed = changeOf(more, await placesOnMap(page));
  expect(removed).toMatchObject({ clips: set.length, isMirrored: false });
  expect(Math.abs(removed.turnedDegrees)).toBeLessThan(2);
});

test('a clip that arrives is on the map before the comparison covers it', async ({ app, page }) => {
  const letGo = await holdComparisons(page);
  await openCompare(app, page, ...set);
  await stillMap(page);
  const before = await placesOnMap(page);
  await page.evaluate('holdComparisons()');
  await app.drop(...sampleFiles('walk-vrm-60'));
  await app.row('walk-vrm-60.bvh').getByRole('button').first().click();
  await expect(mapPoint(page)).toHaveAttribute(
    'aria-label',
    'walk-vrm-60, no label, not compared yet',
  );
  await expect(names(page)).toHaveCount(set.length);
  // The mouse finds it too, and what it is.
  const box = (await mapPoint(page).boundingBox())!;
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  const tip = page.locator('.compare-map .pair-tip');
  await expect(tip).toContainText('walk-vrm-60');
  await expect(tip).toContainText('not compared yet');
  const meanwhile = await placesOnMap(page);
  expect([...meanwhile]).toEqual([...before]);

  await letGo();
  await expect(names(page)).toHaveCount(set.length + 1);
  await app.row('walk-vrm-60.bvh').getByRole('button').first().click();
  await expect(mapPoint(page)).toHaveAttribute(
    'aria-label',
    /^walk-vrm-60, no label, cluster \d+$/,
  );
});
