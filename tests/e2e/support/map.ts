// The map of the page Compare by what it says and where its clips stand. In: a page.
import type { Page } from '@playwright/test';
import { expect } from './test';

export type Places = ReadonlyMap<string, readonly [number, number]>;

export const mapPoint = (page: Page) => page.locator('.map-point');

/** Where every clip stands on the screen, by its name: the arrow keys of the list of names visit them all. */
export async function placesOnMap(page: Page): Promise<Places> {
  const names = page.getByRole('listbox', { name: 'Clips in the order of the matrix' });
  const places = new Map<string, readonly [number, number]>();
  for (const option of await names.getByRole('option').all()) {
    const name = ((await option.getAttribute('aria-label')) ?? '').split(',')[0];
    await option.click();
    await expect(mapPoint(page)).toHaveAttribute('aria-label', new RegExp(`^${name},`));
    const box = await mapPoint(page).boundingBox();
    places.set(name, [box?.x ?? 0, box?.y ?? 0]);
  }
  return places;
}

/** How the places of the clips in both have turned, grown and moved: the best fit of least squares. */
export function changeOf(before: Places, after: Places) {
  const both = [...before].flatMap(([name, from]) => {
    const to = after.get(name);
    return to ? [{ from, to }] : [];
  });
  const middle = (of: 'from' | 'to', axis: 0 | 1): number =>
    both.reduce((sum, pair) => sum + pair[of][axis], 0) / both.length;
  const [fromX, fromY] = [middle('from', 0), middle('from', 1)];
  const [toX, toY] = [middle('to', 0), middle('to', 1)];
  let [along, across, mirrored, mirroredAcross, size] = [0, 0, 0, 0, 0];
  for (const { from, to } of both) {
    const [x, y] = [from[0] - fromX, from[1] - fromY];
    const [u, v] = [to[0] - toX, to[1] - toY];
    along += x * u + y * v;
    across += x * v - y * u;
    mirrored += x * u - y * v;
    mirroredAcross += x * v + y * u;
    size += x * x + y * y;
  }
  return {
    clips: both.length,
    turnedDegrees: (Math.atan2(across, along) * 180) / Math.PI,
    isMirrored: Math.hypot(mirrored, mirroredAcross) > Math.hypot(along, across),
    scale: Math.hypot(along, across) / size,
    movedPx: Math.hypot(toX - fromX, toY - fromY),
  };
}
