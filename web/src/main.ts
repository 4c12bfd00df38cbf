/** Where the page begins: what it is made of is handed to the views. */
import './styles/index.css';
import { followComparison } from './app/comparing';
import type { Context } from './app/context';
import { learnDefaults } from './app/defaults';
import { failureOf } from './app/failure';
import { installIcons } from './common/icons';
import { followOpenClip } from './player/follow-clip';
import { listenToKeys } from './player/keys';
import { runCommand } from './shell/commands';
import { createContext } from './shell/create-context';
import { listenToDrops } from './shell/drop';
import { tellErrors } from './shell/errors';
import { layOut } from './shell/layout';
import { mountPage } from './shell/page';
import { focusPressed } from './shell/press-focus';
import { prefetchStudy } from './shell/prefetch';
import { installTips } from './shell/tips';

function followComparing({ store, comparer, language }: Context): void {
  followComparison({
    store,
    comparer,
    now: () => performance.now(),
    tellError: (error) => {
      const text = language.words.peek().failure(failureOf(error));
      store.toast.value = { kind: 'error', text };
    },
  });
}

function start(root: HTMLElement, context: Context): void {
  const { store, actions } = context;
  const stageOff = new URLSearchParams(location.search).get('stage') === 'off';
  tellErrors(window, context);
  learnDefaults(context.engine, store);
  followComparing(context);
  installIcons(document.body);
  installTips(document.body);
  followOpenClip(store, context.playback, context.engine);
  mountPage(layOut(root), context, {
    off: stageOff,
    reducedMotion: matchMedia('(prefers-reduced-motion: reduce)').matches,
  });
  focusPressed(document);
  listenToKeys(document, (command) => runCommand(context, command));
  listenToDrops(document, {
    onHover: (over) => {
      store.dropping.value = over;
    },
    onDrop: (given) => actions.take(given),
  });
  if (!stageOff) prefetchStudy(context.engine);
}

const root = document.querySelector<HTMLElement>('#app');
if (root) {
  const context = createContext();
  // In a task of its own: together with the first run of the modules it would last over 50 ms.
  void context.language.need('page').then(() => setTimeout(() => start(root, context)));
}
