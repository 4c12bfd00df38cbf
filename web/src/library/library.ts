/** The clips of the page: filter, order, rows. Only the rows in sight exist. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { repeat } from 'lit-html/directives/repeat.js';
import type { ClipId } from '../engine/types';
import type { Clip } from '../app/clips';
import type { MessageKey, Words } from '../app/i18n/catalogue';
import type { Labels } from '../app/labels';
import { sortKeys, type Sort, type SortKey } from '../app/order';
import { iconButton } from '../common/buttons';
import { styled } from '../common/directives';
import { icon } from '../common/icons';
import { menuButton, type MenuItem } from '../common/menu';
import { libraryRow, rowHeightPx, type RowLabel } from './row';
import { rowWindow } from './row-window';

export interface LibraryProps {
  readonly words: Words;
  /** The clips that the filter lets through, in their order. */
  readonly rows: readonly Clip[];
  readonly total: number;
  readonly bytes: number;
  readonly openId: ClipId | null;
  readonly qualifiers: ReadonlyMap<ClipId, string>;
  readonly labels: Labels;
  readonly labelNames: readonly string[];
  readonly filter: string;
  readonly sort: Sort;
  readonly scrollTop: number;
  readonly viewHeight: number;
  readonly onOpen: (id: ClipId) => void;
  readonly onRemove: (id: ClipId) => void;
  readonly onNeighbour: (direction: 1 | -1) => void;
  readonly onFilter: (filter: string) => void;
  readonly onSort: (sort: Sort) => void;
  readonly onScroll: (scrollTop: number) => void;
  readonly onAddFiles: () => void;
  readonly onAddFolder: () => void;
}

const sortLabels: Readonly<Record<SortKey, MessageKey>> = {
  arrival: 'sort.arrival',
  name: 'sort.name',
  length: 'sort.length',
  keyposes: 'sort.keyposes',
};

function sortItems({ words: { t }, sort, onSort }: LibraryProps): MenuItem[] {
  const keys = sortKeys.map((key) => ({
    label: t(sortLabels[key]),
    checked: key === sort.key,
    onChoose: () => onSort({ ...sort, key }),
  }));
  const directions = [false, true].map((descending, index) => ({
    label: t(descending ? 'sort.descending' : 'sort.ascending'),
    checked: descending === sort.descending,
    apart: index === 0,
    onChoose: () => onSort({ ...sort, descending }),
  }));
  return [...keys, ...directions];
}

function head(props: LibraryProps): TemplateResult {
  const { t } = props.words;
  const { rows, total } = props;
  const addItems: MenuItem[] = [
    { label: t('library.add.files'), icon: 'file-up', onChoose: props.onAddFiles },
    { label: t('library.add.folder'), icon: 'folder-open', onChoose: props.onAddFolder },
  ];
  return html`<div class="panel-head">
    <h2>${t('library.title')}</h2>
    <span class="library-count"
      >${rows.length === total ? t('library.count', total) : t('library.count.shown', rows.length, total)}</span
    >
    ${menuButton({ id: 'sort-menu', name: 'arrow-up-down', label: t('library.sort'), items: sortItems(props) })}
    ${menuButton({ id: 'add-menu', name: 'plus', label: t('library.add'), items: addItems })}
  </div>`;
}

function filterField({ words: { t }, filter, onFilter }: LibraryProps): TemplateResult {
  const onInput = (event: Event): void => onFilter((event.target as HTMLInputElement).value);
  const onKey = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape') return;
    const field = event.target as HTMLInputElement;
    // A drawer keeps the focus, and closes with the next press.
    if (!field.closest('.drawer')) field.blur();
    else if (field.value) event.preventDefault();
    onFilter('');
  };
  return html`<div class="field filter">
    ${icon('search', 14)}
    <input
      id="filter"
      type="text"
      autocomplete="off"
      spellcheck="false"
      aria-label=${t('library.filter')}
      aria-keyshortcuts="/"
      placeholder=${t('library.filter')}
      .value=${live(filter)}
      @input=${onInput}
      @keydown=${onKey}
    />
    ${
      filter
        ? iconButton({
            name: 'x',
            label: t('library.filter.clear'),
            size: 14,
            small: true,
            onPress: () => onFilter(''),
          })
        : html`<kbd aria-hidden="true">/</kbd>`
    }
  </div>`;
}

function labelOf({ labels, labelNames }: LibraryProps, id: ClipId): RowLabel | null {
  const name = labels.get(id) ?? null;
  return name === null ? null : { name, index: labelNames.indexOf(name) };
}

function rowsInSight(props: LibraryProps): TemplateResult {
  const { rows, openId, qualifiers, words } = props;
  const { first, end } = rowWindow(rows.length, rowHeightPx, props.scrollTop, props.viewHeight);
  const openInSight = rows.slice(first, end).some(({ id }) => id === openId);
  const row = (clip: Clip, offset: number): TemplateResult =>
    libraryRow({
      words,
      clip,
      qualifier: qualifiers.get(clip.id) ?? '',
      label: labelOf(props, clip.id),
      open: clip.id === openId,
      tabStop: openInSight ? clip.id === openId : offset === 0,
      index: first + offset,
      count: rows.length,
      onOpen: () => props.onOpen(clip.id),
      onRemove: () => props.onRemove(clip.id),
    });
  return html`${repeat(rows.slice(first, end), ({ id }) => id, row)}`;
}

function list(props: LibraryProps): TemplateResult {
  const {
    words: { t },
    rows,
    filter,
  } = props;
  const onKey = (event: KeyboardEvent): void => {
    const step = ({ ArrowDown: 1, ArrowUp: -1 } as const)[event.key as 'ArrowDown' | 'ArrowUp'];
    if (!step) return;
    event.preventDefault();
    props.onNeighbour(step);
  };
  const onScroll = (event: Event): void => props.onScroll((event.target as HTMLElement).scrollTop);
  return html`<div class="library-list" @scroll=${onScroll} @keydown=${onKey}>
    ${rows.length === 0 && filter ? html`<p class="library-nothing">${t('library.nothing', filter)}</p>` : nothing}
    <ul class="library-rows" ${styled({ height: `${rows.length * rowHeightPx}px` })}>
      ${rowsInSight(props)}
    </ul>
  </div>`;
}

export function library(props: LibraryProps): TemplateResult {
  const { t, format } = props.words;
  return html`
    <div class="library-head">${head(props)}${filterField(props)}</div>
    ${list(props)}
    <div class="library-foot">
      ${icon('lock', 13)}<span>${t('library.local')}</span
      ><span class="library-size">${format.bytes(props.bytes)}</span>
    </div>
  `;
}
