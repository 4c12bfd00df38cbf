/** The library on the page: props from the store, events to the actions, the open row kept in sight. */
import { signal, untracked } from '@preact/signals-core';
import type { Context } from '../app/context';
import { follow, mount } from '../common/mount';
import { library, type LibraryProps } from './library';
import { rowHeightPx } from './row';
import { scrollToRow } from './row-window';

interface Scroll {
  readonly top: number;
  readonly height: number;
}

function propsOf(
  { store, actions, language, picker, panels }: Context,
  scroll: Scroll,
  onScroll: (top: number) => void,
): LibraryProps {
  const present = store.present.value;
  return {
    words: language.words.value,
    rows: store.shown.value,
    total: present.length,
    bytes: present.reduce((sum, { source }) => sum + source.blob.size, 0),
    openId: store.openId.value,
    qualifiers: store.qualifiers.value,
    labels: store.labels.value,
    labelNames: store.labelNames.value,
    filter: store.filter.value,
    sort: store.sort.value,
    scrollTop: scroll.top,
    viewHeight: scroll.height,
    onOpen: (id) => {
      actions.openClip(id);
      panels.closeDrawer();
    },
    onRemove: (id) => actions.remove(id),
    onNeighbour: (direction) => actions.openNeighbour(direction),
    onFilter: (filter) => {
      store.filter.value = filter;
    },
    onSort: (sort) => {
      store.sort.value = sort;
    },
    onScroll,
    onAddFiles: () => picker.files(),
    onAddFolder: () => picker.folder(),
  };
}

export function mountLibrary(place: HTMLElement, context: Context): void {
  // The observer below tells the height once the page is laid out.
  const scroll = signal<Scroll>({ top: 0, height: 0 });
  const { store, language } = context;
  const body = document.createElement('div');
  body.className = 'library-body';
  place.append(body);
  new ResizeObserver(() => {
    scroll.value = { ...scroll.peek(), height: place.clientHeight };
  }).observe(place);
  const onScroll = (top: number): void => {
    scroll.value = { ...scroll.peek(), top };
  };
  mount(body, () => {
    place.setAttribute('aria-label', language.words.value.t('library.title'));
    return library(propsOf(context, scroll.value, onScroll));
  });

  // After the rows have been drawn: the open one in sight, and in focus if a row was.
  follow(() => {
    const id = store.openId.value;
    void [store.sort.value, store.filter.value];
    const index = untracked(() => store.shown.value.findIndex((clip) => clip.id === id));
    const list = body.querySelector<HTMLElement>('.library-list');
    if (index < 0 || !list) return;
    const hadFocus = list.contains(document.activeElement);
    list.scrollTop = scrollToRow(index, rowHeightPx, list.scrollTop, list.clientHeight);
    if (hadFocus)
      requestAnimationFrame(() => list.querySelector<HTMLElement>(`[data-clip="${id}"]`)?.focus());
  });
}
