// Files given to a page that has no input of its own. In: a page and paths. Out: an input that holds them.
import type { ElementHandle, Page } from '@playwright/test';

export async function giveFiles(page: Page, paths: readonly string[]): Promise<ElementHandle> {
  const handle = await page.evaluateHandle(() => {
    const element = document.createElement('input');
    element.type = 'file';
    element.multiple = true;
    document.body.append(element);
    return element;
  });
  await handle.setInputFiles([...paths]);
  return handle;
}
