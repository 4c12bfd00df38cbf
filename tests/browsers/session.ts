// A page of a browser under test, whatever protocol drives it. In: functions to run in the page, presses of
// keys and of the pointer, files. Out: what the functions return; what went wrong in the page.

/** What a driver of one protocol must be able to do. */
export interface Driver {
  /** Resolves once the page has loaded. */
  readonly go: (address: string) => Promise<void>;
  /** The JSON text that the expression, awaited, gives; "null" for nothing. */
  readonly evaluate: (expression: string) => Promise<string>;
  /** Puts files into the input of a selector, as the browser's own dialog would. */
  readonly give: (selector: string, paths: readonly string[]) => Promise<void>;
  /** One key after the other is held, then all are let go; values of WebDriver's `normalised key`. */
  readonly press: (keys: readonly string[]) => Promise<void>;
  readonly click: (x: number, y: number) => Promise<void>;
  /** A PNG of the page. */
  readonly picture: () => Promise<Uint8Array>;
  readonly close: () => Promise<void>;
}

const specialKeys: Readonly<Record<string, string>> = {
  Escape: '\uE00C',
  Enter: '\uE007',
  Shift: '\uE008',
  Control: '\uE009',
  End: '\uE010',
  Home: '\uE011',
  ArrowLeft: '\uE012',
  ArrowRight: '\uE014',
};

interface Watched {
  readonly faults: string[];
  /** Files that the page wanted to save: they are not. */
  readonly saved: { name: string; file: Blob | undefined }[];
}

declare global {
  interface Window {
    /** Of a page under watch. */
    watched?: Watched;
  }
}

export class Session {
  constructor(private readonly driver: Driver) {}

  /** Opens the page and watches it from then on. */
  async open(address: string): Promise<void> {
    await this.driver.go(address);
    await this.run(watch);
  }

  /** What a function gives that runs in the page, which sees its arguments alone. */
  async run<A extends readonly unknown[], T>(
    inPage: (...values: A) => T | Promise<T>,
    ...values: A
  ): Promise<T> {
    const call = `(${inPage.toString()})(...${JSON.stringify(values)})`;
    const text = await this.driver.evaluate(
      `(async () => JSON.stringify((await ${call}) ?? null))()`,
    );
    return JSON.parse(text) as T;
  }

  /** Until a function in the page gives something; what it gives. */
  async until<A extends readonly unknown[], T>(
    what: string,
    inPage: (...values: A) => T | Promise<T>,
    ...values: A
  ): Promise<NonNullable<T>> {
    const end = Date.now() + 60_000;
    do {
      const value = await this.run(inPage, ...values);
      if (value) return value;
      await new Promise((resolve) => setTimeout(resolve, 200));
    } while (Date.now() < end);
    throw new Error(`still not after a minute: ${what}`);
  }

  /** A press of the pointer on the first in sight that a selector finds and whose name or text begins so. */
  async click(selector: string, text = ''): Promise<void> {
    const { x, y } = await this.until(`${selector} "${text}"`, findMiddle, selector, text);
    await this.driver.click(x, y);
  }

  /** "Shift+ArrowLeft" and the like; a sign stands for itself. */
  press(chord: string): Promise<void> {
    const keys = chord.length === 1 ? [chord] : chord.split('+');
    return this.driver.press(keys.map((key) => specialKeys[key] ?? key));
  }

  give(selector: string, paths: readonly string[]): Promise<void> {
    return this.driver.give(selector, paths);
  }

  /** The text of the first that a selector finds. */
  text(selector: string): Promise<string> {
    return this.run(
      (all) => (document.querySelector(all)?.textContent ?? '').replace(/\s+/g, ' ').trim(),
      selector,
    );
  }

  /** The names of the files that the page wanted to save, their kinds and their first bytes as text. */
  saved(): Promise<{ name: string; type: string; size: number; head: string }[]> {
    return this.run(async () => {
      const { saved = [] } = window.watched ?? {};
      const told = saved.map(async ({ name, file = new Blob() }) => {
        const head = new Uint8Array(await file.slice(0, 8).arrayBuffer());
        return { name, type: file.type, size: file.size, head: String.fromCharCode(...head) };
      });
      return Promise.all(told);
    });
  }

  faults(): Promise<string[]> {
    return this.run(() => window.watched?.faults ?? ['the page was left']);
  }

  picture(): Promise<Uint8Array> {
    return this.driver.picture();
  }

  close(): Promise<void> {
    return this.driver.close();
  }
}

/** Runs in the page. */
function watch(): void {
  const watched: Watched = { faults: [], saved: [] };
  window.watched = watched;
  const note = (text: string): void => void watched.faults.push(text);
  addEventListener('error', ({ message }) => {
    if (!message.startsWith('ResizeObserver loop')) note(message);
  });
  addEventListener('unhandledrejection', ({ reason }) => note(String(reason)));
  addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI }) =>
    note(`policy ${violatedDirective}: ${blockedURI}`),
  );
  Object.assign(console, { error: (...all: unknown[]) => note(all.map(String).join(' ')) });
  const files = new Map<string, Blob>();
  const address = URL.createObjectURL.bind(URL);
  URL.createObjectURL = (object: Blob) => {
    const url = address(object);
    files.set(url, object);
    return url;
  };
  HTMLAnchorElement.prototype.click = function () {
    watched.saved.push({ name: this.download, file: files.get(this.href) });
  };
}

/** Runs in the page: the middle of an element that is in sight and stands still; null: there is none. */
async function findMiddle(
  selector: string,
  text: string,
): Promise<{ x: number; y: number } | null> {
  const words = (element: Element): string[] =>
    [element.getAttribute('aria-label') ?? '', element.textContent ?? ''].map((one) => one.trim());
  const found = [...document.querySelectorAll(selector)].find(
    (element) =>
      element.checkVisibility({ visibilityProperty: true }) &&
      !element.matches(':disabled') &&
      words(element).some((one) => one.startsWith(text)),
  );
  if (!found) return null;
  found.scrollIntoView({ block: 'nearest' });
  const before = found.getBoundingClientRect();
  await new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn)));
  const { left, top, width, height } = found.getBoundingClientRect();
  if (left !== before.left || top !== before.top) return null;
  return { x: Math.round(left + width / 2), y: Math.round(top + height / 2) };
}
