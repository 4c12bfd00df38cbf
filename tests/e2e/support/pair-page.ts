/** The page Pair of the app in; what its tests do on it out. */
import type { Locator, Page } from '@playwright/test';
import type { AppPage } from './app-page';

export async function openPair(app: AppPage, ...paths: string[]): Promise<void> {
  await app.openWith(...paths);
  await showPage(app.page, 'Pair');
}

export async function showPage(page: Page, name: string): Promise<void> {
  await page.locator('.page-tab', { hasText: name }).click();
}

export const clipButton = (page: Page, which: 'a' | 'b' | 'more'): Locator =>
  page.locator(`[popovertarget="pair-clip-${which}"]`);
