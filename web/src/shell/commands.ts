/** A command of the keyboard in; what it does on the page out. */
import type { Context } from '../app/context';
import type { KeyCommand } from '../player/keys';
import { zoom } from '../transport/zooming';

type Run = (context: Context) => void;

const tenthS = 0.1;

const focusFilter = (): void => document.querySelector<HTMLInputElement>('#filter')?.select();

const commands: Readonly<Record<KeyCommand, Run>> = {
  play: ({ playback }) => playback.toggle(),
  'frame-back': ({ playback }) => playback.step(-1),
  'frame-on': ({ playback }) => playback.step(1),
  'tenth-back': ({ playback }) => playback.skip(-tenthS),
  'tenth-on': ({ playback }) => playback.skip(tenthS),
  'next-keypose': ({ playback }) => playback.keypose(1),
  'previous-keypose': ({ playback }) => playback.keypose(-1),
  'first-frame': ({ playback }) => playback.toEnd(-1),
  'last-frame': ({ playback }) => playback.toEnd(1),
  slower: ({ playback }) => playback.speed(-1),
  faster: ({ playback }) => playback.speed(1),
  loop: ({ playback }) => playback.loop(),
  'loop-start': ({ playback }) => playback.loopEnd('a'),
  'loop-end': ({ playback }) => playback.loopEnd('b'),
  'loop-clear': ({ playback }) => playback.setLoop(null),
  'zoom-in': ({ store }) => zoom(store, 'in'),
  'zoom-out': ({ store }) => zoom(store, 'out'),
  'zoom-all': ({ store }) => zoom(store, 'all'),
  'full-screen': ({ fullScreen, store }) => {
    if (store.present.peek().length > 0) fullScreen.toggle();
  },
  help: ({ store }) => {
    store.helpOpen.value = true;
  },
  filter: ({ panels, store }) => {
    if (store.present.peek().length === 0) return;
    if (panels.library.open.peek()) return focusFilter();
    panels.library.toggle();
    // The panel shows with the next frame.
    requestAnimationFrame(() => requestAnimationFrame(focusFilter));
  },
  undo: ({ actions }) => actions.undo(),
  redo: ({ actions }) => actions.redo(),
};

/** What holds on every page; the other commands are about the time of the page that is shown. */
const everywhere: ReadonlySet<KeyCommand> = new Set([
  'full-screen',
  'help',
  'filter',
  'undo',
  'redo',
]);

export function runCommand(context: Context, command: KeyCommand): void {
  const page = context.store.compare.page.peek();
  if (page === 'study' || everywhere.has(command)) commands[command](context);
  else context.pageKeys.get(page)?.(command);
}
