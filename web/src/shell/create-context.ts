/** Nothing in; state, engine and those who may change them, made here and handed to each other, out. */
import { createActions } from '../app/actions';
import { createCompareActions } from '../app/compare-actions';
import type { Context } from '../app/context';
import { createFullScreen } from '../app/full-screen';
import { createHistory } from '../app/history';
import { createLanguage } from '../app/language';
import { createPanels } from '../app/panels';
import { createPreferences } from '../app/preferences';
import { createStore } from '../app/store';
import { createTheme } from '../app/theme';
import { createBrowserEngine } from '../engine/browser-engine';
import { createBrowserComparer } from '../engine/browser-comparer';
import type { ClipId } from '../engine/types';
import { createPlayback } from '../player/playback';
import { createPicker } from './pick';

export function createContext(): Context {
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
    compareActions: createCompareActions({ store, history, words, openClip }),
    language,
    theme: createTheme(preferences, matchMedia('(prefers-color-scheme: dark)')),
    panels: createPanels(preferences, (query) => matchMedia(query)),
    fullScreen: createFullScreen(document),
    preferences,
    pageKeys: new Map(),
    picker: createPicker(document.body, (given) => actions.take(given)),
  };
}
