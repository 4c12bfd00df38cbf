// Firefox by WebDriver BiDi, which it speaks itself. In: its program. Out: a driver of one page.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { clickActions, keyActions } from './actions';
import { BidiLine } from './bidi-line';
import { Place, findProgram, freePort, toldBy } from './program';
import type { Driver } from './session';

/** FIREFOX_PATH, else an installed one; null: none. */
export const findFirefox = (): string | null =>
  process.env['FIREFOX_PATH'] ??
  findProgram('firefox-esr', 'firefox', '/Applications/Firefox.app/Contents/MacOS/firefox');

/** It asks nobody for anything, and draws WebGL in software. */
const preferences = {
  'app.update.enabled': false,
  'browser.aboutwelcome.enabled': false,
  'browser.shell.checkDefaultBrowser': false,
  'datareporting.policy.dataSubmissionEnabled': false,
  'remote.active-protocols': 1,
  'webgl.force-enabled': true,
};

export async function startFirefox(program: string): Promise<Driver> {
  const place = await Place.make();
  const lines = Object.entries(preferences).map(
    ([name, value]) => `user_pref(${JSON.stringify(name)}, ${JSON.stringify(value)});`,
  );
  writeFileSync(join(place.folder, 'user.js'), lines.join('\n'));
  const port = await freePort();
  const profile = ['--no-remote', '--profile', place.folder];
  const child = place.spawn(program, [...profile, `--remote-debugging-port=${port}`]);
  const address = await toldBy(child, /(?<=WebDriver BiDi listening on )ws:\S+/);
  const line = await BidiLine.to(`${address}/session`);
  await line.send('session.new', { capabilities: {} });
  // The first tab of a new window is not in focus.
  const { context } = await line.send<{ context: string }>('browsingContext.create', {
    type: 'tab',
  });
  await line.send('browsingContext.activate', { context });
  const viewport = { width: 1440, height: 900 };
  await line.send('browsingContext.setViewport', { context, viewport });
  const close = async (): Promise<void> => {
    await line.send('browser.close', {}).catch(() => undefined);
    await place.leave();
  };
  return { ...pageOf(line, context), close };
}

function pageOf(line: BidiLine, context: string): Omit<Driver, 'close'> {
  const act = async (action: object): Promise<void> => {
    await line.send('input.performActions', { context, actions: [action] });
  };
  const evaluate = async (expression: string): Promise<RemoteValue> => {
    const options = { target: { context }, awaitPromise: true, expression };
    const answer = await line.send<Evaluation>('script.evaluate', options);
    if (answer.exceptionDetails) throw new Error(answer.exceptionDetails.text);
    return answer.result;
  };
  return {
    go: async (url) => {
      await line.send('browsingContext.navigate', { context, url, wait: 'complete' });
    },
    evaluate: async (expression) => (await evaluate(expression)).value ?? 'null',
    give: async (selector, files) => {
      const element = await evaluate(`document.querySelector(${JSON.stringify(selector)})`);
      await line.send('input.setFiles', { context, element, files });
    },
    press: (keys) => act(keyActions(keys)),
    click: (x, y) => act(clickActions(x, y)),
    picture: async () => {
      const { data } = await line.send<{ data: string }>('browsingContext.captureScreenshot', {
        context,
      });
      return Buffer.from(data, 'base64');
    },
  };
}

interface RemoteValue {
  readonly value?: string;
  readonly sharedId?: string;
}

interface Evaluation {
  readonly result: RemoteValue;
  readonly exceptionDetails?: { readonly text: string };
}
