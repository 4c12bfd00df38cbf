// WebKitGTK by WebDriver, as in Debian's webkit2gtk-driver. In: the driver's program. Out: a driver of one page.
import { clickActions, keyActions } from './actions';
import { Place, findProgram, freePort } from './program';
import type { Driver } from './session';

/** WEBKIT_DRIVER_PATH, else an installed one; null: none. */
export const findWebKit = (): string | null =>
  process.env['WEBKIT_DRIVER_PATH'] ?? findProgram('WebKitWebDriver');

export async function startWebKit(program: string): Promise<Driver> {
  const place = await Place.make();
  const port = await freePort();
  place.spawn(program, [`--port=${port}`]);
  const address = `http://127.0.0.1:${port}`;
  await untilReady(address);
  const { sessionId } = await ask<{ sessionId: string }>(`${address}/session`, {
    capabilities: {},
  });
  const session = `${address}/session/${sessionId}`;
  await ask(`${session}/timeouts`, { script: 120_000, pageLoad: 120_000 });
  await ask(`${session}/window/rect`, { width: 1440, height: 960 });
  const close = async (): Promise<void> => {
    await ask(session, null, 'DELETE').catch(() => undefined);
    await place.leave();
  };
  return { ...pageOf(session), close };
}

function pageOf(session: string): Omit<Driver, 'close'> {
  const act = async (action: object): Promise<void> => {
    await ask(`${session}/actions`, { actions: [action] });
  };
  return {
    go: async (url) => {
      await ask(`${session}/url`, { url });
    },
    evaluate: async (expression) => {
      const script = `const told = arguments[0];
        ${expression}.then((value) => told({ value }), (error) => told({ error: String(error) }));`;
      const run = { script, args: [] };
      const { value, error } = await ask<Told>(`${session}/execute/async`, run);
      if (error !== undefined) throw new Error(error);
      return value ?? 'null';
    },
    give: async (selector, files) => {
      const wanted = { using: 'css selector', value: selector };
      const element = await ask<Record<string, string>>(`${session}/element`, wanted);
      const text = files.join('\n');
      await ask(`${session}/element/${Object.values(element)[0]}/value`, { text });
    },
    press: (keys) => act(keyActions(keys)),
    click: (x, y) => act(clickActions(x, y)),
    picture: async () =>
      Buffer.from(await ask<string>(`${session}/screenshot`, null, 'GET'), 'base64'),
  };
}

interface Told {
  readonly value?: string;
  readonly error?: string;
}

async function ask<T>(address: string, body: object | null, method = 'POST'): Promise<T> {
  const headers = { 'content-type': 'application/json' };
  const text = body && JSON.stringify(body);
  const answer = await fetch(address, { method, headers, body: text });
  const { value } = (await answer.json()) as { value: T & { message?: string } };
  if (!answer.ok) throw new Error(`${new URL(address).pathname}: ${value.message}`);
  return value;
}

async function untilReady(address: string): Promise<void> {
  for (let n = 0; n < 100; n++) {
    const ready = await fetch(`${address}/status`).catch(() => null);
    if (ready) return;
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  throw new Error(`no answer from ${address}`);
}
