/** The library on the page: props from the store, events to the actions, the open row kept in sight. */
import { computed, signal, untracked, type Signal } from '@preact/signals-core';
import type { Context } from '../app/context';
import { follow, mount } from '../common/mount';
import { libraryLayout, placeOfClip, type LibraryLayout } from './entries';
import { library, type LibraryProps } from './library';
import { LibraryList } from './library-list';

interface Scroll {
  readonly top: number;
  readonly height: number;
}

/** What only the library knows of itself. */
interface LibraryState {
  readonly scroll: Signal<Scroll>;
  readonly renaming: Signal<string | null>;
  readonly layout: { readonly value: LibraryLayout };
  readonly list: LibraryList;
}

type Events = Pick<LibraryProps, Extract<keyof LibraryProps, `on${string}`>>;

function eventsOf(context: Context, state: LibraryState): Events {
  const { store, actions, compareActions, picker } = context;
  const { list, scroll, renaming } = state;
  return {
    onPress: (id, event) => list.press(id, event),
    onRemove: (id) => list.remove(id),
    onListKey: (event) => list.key(event),
    onFilter: (filter) => (store.filter.value = filter),
    onSort: (sort) => (store.sort.value = sort),
    onGrouped: (grouped) => (store.groupByLabel.value = grouped),
    onFold: (label, folded) => {
      const next = new Set(store.foldedLabels.peek());
      if (folded) next.add(label);
      else next.delete(label);
      store.foldedLabels.value = next;
    },
    onRename: (label) => {
      renaming.value = label;
      list.focus('.group-name-field');
    },
    onRenamed: (name) => {
      const label = renaming.peek();
      renaming.value = null;
      if (label === null) return;
      if (name) compareActions.renameLabel(label, name);
      list.focus(`[data-group="${CSS.escape(name || label)}"]`);
    },
    onLabelTicked: (label) => compareActions.labelByHand([...store.ticked.peek()], label),
    onRemoveTicked: () => actions.remove(...store.ticked.peek()),
    onClearTicked: () => (store.ticked.value = new Set()),
    onScroll: (top) => (scroll.value = { ...scroll.peek(), top }),
    onAddFiles: () => picker.files(),
    onAddFolder: () => picker.folder(),
  };
}

function propsOf({ store, language }: Context, state: LibraryState, events: Events): LibraryProps {
  const present = store.present.value;
  const { page, otherId } = store.compare;
  const { top, height } = state.scroll.value;
  return {
    ...events,
    words: language.words.value,
    layout: state.layout.value,
    listed: store.shown.value.length,
    total: present.length,
    bytes: present.reduce((sum, { source }) => sum + source.blob.size, 0),
    openId: store.openId.value,
    otherId: page.value === 'study' ? null : otherId.value,
    ticked: store.ticked.value,
    grouped: store.labelNames.value.length > 0 ? store.groupByLabel.value : null,
    renaming: state.renaming.value,
    qualifiers: store.qualifiers.value,
    labels: store.labels.value,
    labelNames: store.labelNames.value,
    filter: store.filter.value,
    sort: store.sort.value,
    scrollTop: top,
    viewHeight: height,
  };
}

function createState(context: Context, body: HTMLElement): LibraryState {
  const { shown, labels, grouped, foldedLabels } = context.store;
  const layout = computed(() =>
    libraryLayout({
      rows: shown.value,
      labels: labels.value,
      grouped: grouped.value,
      folded: foldedLabels.value,
    }),
  );
  return {
    // An observer tells the height once the page is laid out.
    scroll: signal<Scroll>({ top: 0, height: 0 }),
    renaming: signal<string | null>(null),
    layout,
    list: new LibraryList(context, body, () => layout.peek()),
  };
}

export function mountLibrary(place: HTMLElement, context: Context): void {
  const body = document.createElement('div');
  body.className = 'library-body';
  place.append(body);
  const state = createState(context, body);
  const { scroll } = state;
  new ResizeObserver(() => {
    scroll.value = { ...scroll.peek(), height: place.clientHeight };
  }).observe(place);
  const events = eventsOf(context, state);
  mount(body, () => {
    place.setAttribute('aria-label', context.language.words.value.t('library.title'));
    return library(propsOf(context, state, events));
  });
  keepInSight(context, state, body);
}

/** After the rows have been drawn: the open one in sight, and in focus if a row was; else a filter begins at the top. */
function keepInSight({ store }: Context, { layout, list }: LibraryState, body: HTMLElement): void {
  let filterBefore = '';
  follow(() => {
    const id = store.openId.value;
    const filter = store.filter.value;
    void [store.sort.value, store.grouped.value];
    const place = untracked(() => placeOfClip(layout.value, id));
    if (place >= 0) list.reveal(place);
    else if (filter !== filterBefore && list.list) list.list.scrollTop = 0;
    filterBefore = filter;
    const hadFocus =
      list.list?.contains(document.activeElement) && !body.querySelector('input:focus');
    if (place >= 0 && hadFocus) list.focus(`[data-clip="${id}"]`);
  });
}
