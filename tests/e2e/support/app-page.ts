// The app in the browser, as a person meets it: what is dropped on it, what it shows. In: a page.
import { resolve } from 'node:path';
import { type Locator, type Page, expect } from '@playwright/test';

/** Nothing is drawn: the software rasteriser would block the page. */
export const stageOff = '?stage=off';

export class AppPage {
  constructor(readonly page: Page) {}

  async open(search = stageOff): Promise<void> {
    await this.page.goto(`./${search}`);
    await expect(this.page.locator('.top-bar')).toContainText('Keypose');
  }

  /** A real drop of files and folders from the disk, as the browser hands it on. */
  async drop(...paths: string[]): Promise<void> {
    const session = await this.page.context().newCDPSession(this.page);
    const data = { items: [], files: paths.map((path) => resolve(path)), dragOperationsMask: 1 };
    for (const type of ['dragEnter', 'dragOver', 'drop'] as const) {
      await session.send('Input.dispatchDragEvent', { type, x: 300, y: 300, data });
    }
    await session.detach();
  }

  /** Opens the page, drops, and waits until everything has been read. */
  async openWith(...paths: string[]): Promise<void> {
    await this.open();
    await this.drop(...paths);
    await this.settled();
  }

  /** Nothing is being read any more, and there are rows. */
  async settled(): Promise<void> {
    // Attached, not visible: in a narrow window the library is a closed drawer.
    await expect(this.rows.first()).toBeAttached();
    await expect(this.page.locator('.progress-card')).toHaveCount(0);
    await expect(this.page.locator('.clip progress')).toHaveCount(0);
    await expect(this.page.locator('.outdated')).toHaveCount(0);
  }

  get rows(): Locator {
    return this.page.locator('.clip');
  }

  /** The names of the rows, each after what tells it from namesakes, come to be these, from top to bottom. */
  async expectNames(...names: string[]): Promise<void> {
    await expect.poll(() => this.names()).toEqual(names);
  }

  private async names(): Promise<string[]> {
    const rows = await this.rows.evaluateAll((items) =>
      items.map((item) => ({
        place: Number(item.getAttribute('aria-posinset')),
        name: item.querySelector('.clip-name')?.getAttribute('title') ?? '',
      })),
    );
    return rows.sort((a, b) => a.place - b.place).map(({ name }) => name);
  }

  row(name: string): Locator {
    return this.rows.filter({ has: this.page.locator(`.clip-name[title$="${name}"]`) });
  }

  /** The clip on the stage, by the top bar. */
  get openName(): Locator {
    return this.page.locator('.top-clip .clip-name');
  }

  get toast(): Locator {
    return this.page.locator('.toast-text');
  }

  get caption(): Locator {
    return this.page.locator('.stage-caption');
  }

  /** Chooses a tab of the side panel, in English or in Japanese. */
  async tab(name: string): Promise<void> {
    const tab = this.page.getByRole('tab', { name: new RegExp(`^${name}`) });
    await tab.click();
    await expect(tab).toHaveAttribute('aria-selected', 'true');
  }

  /** The section of the chosen tab with this title. */
  section(title: string): Locator {
    return this.page.getByRole('region', { name: title, exact: true });
  }

  /** The control with this label, and not the button that sets it back. */
  field(label: string): Locator {
    return this.page.getByLabel(label, { exact: true });
  }

  /** The frame shown by the transport. */
  async frame(): Promise<number> {
    const text = await this.page.locator('.clock-frame').innerText();
    return Number(/\d+/.exec(text)?.[0]);
  }

  async expectFrame(frame: number): Promise<void> {
    await expect.poll(() => this.frame()).toBe(frame);
  }

  button(name: string | RegExp): Locator {
    return this.page.getByRole('button', { name, exact: true });
  }
}
