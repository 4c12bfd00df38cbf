/** The whole page: every place filled, and the few things that concern all of them. */
import { effect } from '@preact/signals-core';
import { follow, mount } from '../common/mount';
import { inTasks } from '../common/tasks';
import { installSplitter } from '../common/splitter';
import type { Context } from '../app/context';
import { themeChoices } from '../app/theme';
import { mountEmpty } from '../empty/mount-empty';
import { mountInspector } from '../inspector/mount-inspector';
import { mountLibrary } from '../library/mount-library';
import { mountStage, type StageSettings } from '../study/mount-stage';
import { mountStrip } from '../study/mount-strip';
import { mountTimeline } from '../study/mount-timeline';
import { mountTransport } from '../transport/mount-transport';
import { Drawers } from './drawers';
import { helpDialog } from './help-dialog';
import type { Places } from './layout';
import { followHistory } from './page-history';
import { showPages } from './pages';
import { notices } from './toasts';
import { topBar, type OpenClipPlace, type TopBarProps } from './top-bar';

/** What a visitor meets first; the study is mounted in tasks of its own, so that none lasts 50 ms. */
export function mountPage(places: Places, context: Context, settings: StageSettings): void {
  wearTheTheme(context);
  mountTopBar(places, context);
  mountEmpty(places.empty, context);
  mountNotices(places, context);
  showWhatIsDue(places, context);
  showPages(places, context, settings);
  followHistory(context.store.compare.page);
  speakTheLanguage(context);
  mountStudy(places, context, settings);
}

function mountStudy(places: Places, context: Context, settings: StageSettings): void {
  const {
    stage,
    'stage-figure': figure,
    'stage-overlay': overlay,
    'spoken-caption': spoken,
  } = places;
  inTasks([
    () => mountLibrary(places.library, context),
    () => mountInspector(places.inspector, context),
    () => mountStage({ stage, figure, overlay, spoken }, context, settings),
    () => {
      mountTransport(places.transport, context);
      mountStrip(places.strip, context);
      mountTimeline(places.timeline, context);
    },
    () => {
      mountHelp(places, context);
      mountSplitters(places, context);
    },
  ]);
}

function clipPlace({ store }: Context): OpenClipPlace | null {
  const clip = store.openClip.value;
  if (!clip) return null;
  const shown = store.shown.value;
  const place = shown.findIndex(({ id }) => id === clip.id) + 1;
  const label = store.labels.value.get(clip.id);
  return {
    name: clip.source.name,
    qualifier: store.qualifiers.value.get(clip.id) ?? '',
    label: label ? { name: label, place: store.labelNames.value.indexOf(label) } : null,
    place,
    count: shown.length,
  };
}

const isStudy = ({ store }: Context): boolean => store.compare.page.value === 'study';

/** A file that could not be read has none. */
const hasDetails = ({ store }: Context): boolean => {
  const clip = store.openClip.value;
  return clip !== null && clip.status !== 'failed';
};

function topBarProps(context: Context): TopBarProps {
  const { store, history, theme, language, actions, panels } = context;
  const words = language.words.value;
  const { undo, redo } = history.next.value;
  const study = store.present.value.length > 0 || undo || redo;
  const choice = theme.choice.value;
  return {
    words,
    themeChoice: choice,
    study: study
      ? {
          page: store.compare.page.value,
          clip: clipPlace(context),
          undo: undo?.label ?? null,
          redo: redo?.label ?? null,
          panels: store.present.value.length > 0,
          libraryOpen: panels.library.open.value,
          inspectorOpen:
            isStudy(context) && hasDetails(context) ? panels.inspector.open.value : null,
        }
      : null,
    onPage: (page) => context.compareActions.showPage(page),
    onClip: (direction) => actions.openNeighbour(direction),
    onUndo: () => actions.undo(),
    onRedo: () => actions.redo(),
    // What cannot be fetched is told by the page's own listener.
    onLanguage: () => void language.choose(words.language === 'en' ? 'ja' : 'en'),
    onTheme: () =>
      theme.choose(
        themeChoices[(themeChoices.indexOf(choice) + 1) % themeChoices.length] ?? 'system',
      ),
    onHelp: () => {
      store.helpOpen.value = true;
    },
    onLibrary: () => panels.library.toggle(),
    onInspector: () => panels.inspector.toggle(),
  };
}

function mountTopBar(places: Places, context: Context): void {
  mount(places['top-bar'], () => topBar(topBarProps(context)));
}

function mountNotices(places: Places, { store, actions, language }: Context): void {
  mount(places.notices, () =>
    notices({
      words: language.words.value,
      loading: store.loading.value,
      toast: store.toast.value,
      onCancel: () => actions.cancelLoading(),
      onClose: () => {
        store.toast.value = null;
      },
    }),
  );
  let timer: ReturnType<typeof setTimeout> | undefined;
  follow(() => {
    const toast = store.toast.value;
    clearTimeout(timer);
    // Errors stay until they are closed.
    if (!toast || toast.kind === 'error') return;
    timer = setTimeout(() => {
      if (store.toast.peek() === toast) store.toast.value = null;
    }, toastMs);
  });
}

const toastMs = 8000;

function mountHelp(places: Places, { store, language }: Context): void {
  const dialog = places.help as HTMLDialogElement;
  const close = (): void => dialog.close();
  mount(dialog, () => helpDialog(language.words.value, close));
  dialog.addEventListener('close', () => {
    store.helpOpen.value = false;
  });
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) close();
  });
  follow(() => {
    if (store.helpOpen.value && !dialog.open) dialog.showModal();
    else if (!store.helpOpen.value && dialog.open) dialog.close();
  });
}

function mountSplitters(places: Places, { language, preferences }: Context): void {
  const { library, inspector } = places;
  const splitters = [
    {
      panel: library,
      edge: 'right',
      property: '--library-width',
      usual: 256,
      least: 200,
      most: 400,
      key: 'library.resize',
    },
    {
      panel: inspector,
      edge: 'left',
      property: '--inspector-width',
      usual: 300,
      least: 280,
      most: 420,
      key: 'inspector.resize',
    },
  ] as const;
  for (const { key, ...splitter } of splitters) {
    const handle = installSplitter(splitter, preferences);
    follow(() => handle.setAttribute('aria-label', language.words.value.t(key)));
  }
}

/** Two motions beside each other need all the width; details are the study's. */
function isDue(panel: 'library' | 'inspector', context: Context): boolean {
  if (panel === 'library') return context.store.compare.page.value !== 'pair';
  return isStudy(context) && hasDetails(context);
}

/** Empty page or study, panels, drawers, veil. */
function showWhatIsDue(places: Places, context: Context): void {
  const { store, panels, language } = context;
  const drawers = new Drawers([places.study, places.library, places.inspector]);
  follow(() => {
    const hasClips = store.present.value.length > 0;
    places.empty.hidden = hasClips;
    places.workspace.hidden = !hasClips;
    document.documentElement.dataset['page'] = hasClips ? store.compare.page.value : 'empty';
  });
  follow(() => {
    document.documentElement.toggleAttribute('data-full-screen', context.fullScreen.active.value);
  });
  follow(() => {
    for (const name of ['library', 'inspector'] as const) {
      const due = isDue(name, context);
      places[name].hidden = !due || !panels[name].open.value;
      places[name].classList.toggle('drawer', !panels[name].docked.value);
    }
    const open = (['library', 'inspector'] as const).find(
      (name) => !panels[name].docked.value && !places[name].hidden,
    );
    places.scrim.hidden = !open;
    drawers.show(open ? places[open] : null);
  });
  places.scrim.addEventListener('click', () => panels.closeDrawer());
  document.addEventListener('keydown', (event) => {
    const other = document.querySelector('dialog[open], :popover-open');
    if (event.key === 'Escape' && !event.defaultPrevented && !other) panels.closeDrawer();
  });
  follow(() => {
    places['drop-veil'].hidden = !store.dropping.value;
    places['drop-veil'].textContent = language.words.value.t('drop.veil');
  });
}

/** At once and before all else: the stage and the canvases read their colours from it. */
function wearTheTheme({ theme }: Context): void {
  effect(() => {
    document.documentElement.dataset['theme'] = theme.theme.value;
  });
}

function speakTheLanguage({ store, language }: Context): void {
  follow(() => {
    // Even where it stays the same, to set it styles the whole page anew: never with the title.
    document.documentElement.lang = language.words.value.language;
  });
  follow(() => {
    const name = store.openClip.value?.source.name;
    document.title = name ? `${name} · Keypose` : 'Keypose';
  });
}
