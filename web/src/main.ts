/** Where the page begins: state, engine and views are made here and handed to each other. */
import './styles/index.css';
import { createActions } from './app/actions';
import { createCompareActions } from './app/compare-actions';
import type { Context } from './app/context';
import { learnDefaults } from './app/defaults';
import { createFullScreen } from './app/full-screen';
import { createHistory } from './app/history';
import { createLanguage } from './app/language';
import { createPanels } from './app/panels';
import { createPreferences } from './app/preferences';
import { createStore } from './app/store';
import { createTheme } from './app/theme';
import { installIcons } from './common/icons';
import { createBrowserEngine } from './engine/browser-engine';
import { createBrowserComparer } from './engine/browser-comparer';
import type { ClipId } from './engine/types';
import { followOpenClip } from './player/follow-clip';
import { listenToKeys } from './player/keys';
import { createPlayback } from './player/playback';
import { runCommand } from './shell/commands';
import { listenToDrops } from './shell/drop';
import { tellErrors } from './shell/errors';
import { layOut } from './shell/layout';
import { mountPage } from './shell/page';
import { createPicker } from './shell/pick';
import { prefetchStudy } from './shell/prefetch';
import { installTips } from './shell/tips';

function createContext(): Context {
  const preferences = createPreferences(() => localStorage);
  const language = createLanguage(preferences, navigator.languages);
  const store = createStore();
  const history = createHistory();
  const engine = createBrowserEngine(location.search);
  const comparer = createBrowserComparer(engine);
  const words = () => language.words.peek();
  const actions = createActions({ engine, store, history, words });
  const openClip = (id: ClipId | null): void => actions.openClip(id);
  return {
    engine,
    comparer,
    store,
    history,
    playback: createPlayback(store),
    actions,
    compareActions: createCompareActions({ store, history, comparer, words, openClip }),
    language,
    theme: createTheme(preferences, matchMedia('(prefers-color-scheme: dark)')),
    panels: createPanels(preferences, (query) => matchMedia(query)),
    fullScreen: createFullScreen(document),
    preferences,
    pageKeys: new Map(),
    picker: createPicker(document.body, (given) => actions.take(given)),
  };
}

function start(root: HTMLElement, context: Context): void {
  const { store, actions } = context;
  const stageOff = new URLSearchParams(location.search).get('stage') === 'off';
  tellErrors(window, context);
  learnDefaults(context.engine, store);
  installIcons(document.body);
  installTips(document.body);
  followOpenClip(store, context.playback, context.engine);
  mountPage(layOut(root), context, {
    off: stageOff,
    reducedMotion: matchMedia('(prefers-reduced-motion: reduce)').matches,
  });
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
  setTimeout(() => start(root, context));
}
