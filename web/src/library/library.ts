/** The clips of the page: filter, order, groups, rows, what is ticked. Only the rows in sight exist. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { repeat } from 'lit-html/directives/repeat.js';
import type { ClipId } from '../engine/types';
import type { MessageKey, Words } from '../app/i18n/catalogue';
import type { Labels } from '../app/labels';
import { sortKeys, type Sort, type SortKey } from '../app/order';
import { iconButton } from '../common/buttons';
import { styled } from '../common/directives';
import { icon } from '../common/icons';
import { menuButton, type MenuItem } from '../common/menu';
import {
  heightOf,
  type ClipEntry,
  type GroupEntry,
  type LibraryEntry,
  type LibraryLayout,
} from './entries';
import { groupHead } from './group-head';
import { libraryRow, type RowLabel } from './row';
import { unevenWindow } from './row-window';
import { tickedBar } from './ticked-bar';

export interface LibraryProps {
  readonly words: Words;
  readonly layout: LibraryLayout;
  /** Clips that the filter lets through. */
  readonly listed: number;
  readonly total: number;
  readonly bytes: number;
  readonly openId: ClipId | null;
  /** The second of the pair that is compared. */
  readonly otherId: ClipId | null;
  readonly ticked: ReadonlySet<ClipId>;
  /** null: there are no labels to group by. */
  readonly grouped: boolean | null;
  /** The label whose name is being written. */
  readonly renaming: string | null;
  readonly qualifiers: ReadonlyMap<ClipId, string>;
  readonly labels: Labels;
  readonly labelNames: readonly string[];
  readonly filter: string;
  readonly sort: Sort;
  readonly scrollTop: number;
  readonly viewHeight: number;
  readonly onPress: (id: ClipId, event: MouseEvent) => void;
  readonly onRemove: (id: ClipId) => void;
  readonly onListKey: (event: KeyboardEvent) => void;
  readonly onGrouped: (grouped: boolean) => void;
  readonly onFold: (label: string | null, folded: boolean) => void;
  readonly onRename: (label: string) => void;
  /** null: it keeps its name. */
  readonly onRenamed: (name: string | null) => void;
  readonly onLabelTicked: (label: string) => void;
  readonly onRemoveTicked: () => void;
  readonly onClearTicked: () => void;
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

function sortItems({ words: { t }, sort, grouped, onSort, onGrouped }: LibraryProps): MenuItem[] {
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
  if (grouped === null) return [...keys, ...directions];
  const group = { label: t('library.group'), checked: grouped, several: true, apart: true };
  return [...keys, ...directions, { ...group, onChoose: () => onGrouped(!grouped) }];
}

function head(props: LibraryProps): TemplateResult {
  const { t } = props.words;
  const { listed, total } = props;
  const addItems: MenuItem[] = [
    { label: t('library.add.files'), icon: 'file-up', onChoose: props.onAddFiles },
    { label: t('library.add.folder'), icon: 'folder-open', onChoose: props.onAddFolder },
  ];
  return html`<div class="panel-head">
    <h2>${t('library.title')}</h2>
    <span class="library-count"
      >${listed === total ? t('library.count', total) : t('library.count.shown', listed, total)}</span
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

function clipRow(
  props: LibraryProps,
  { clip, index }: ClipEntry,
  top: number,
  tabStop: boolean,
): TemplateResult {
  const { words, openId, otherId, qualifiers, ticked } = props;
  return libraryRow({
    words,
    clip,
    qualifier: qualifiers.get(clip.id) ?? '',
    label: labelOf(props, clip.id),
    grouped: props.grouped ?? false,
    open: clip.id === openId,
    other: clip.id === otherId,
    ticked: ticked.has(clip.id),
    top,
    tabStop,
    index,
    count: props.listed,
    onPress: (event) => props.onPress(clip.id, event),
    onRemove: () => props.onRemove(clip.id),
  });
}

function headRow(props: LibraryProps, group: GroupEntry, top: number): TemplateResult {
  const { words, labels, labelNames, openId, renaming } = props;
  const { label } = group;
  return groupHead({
    words,
    group,
    place: label === null ? -1 : labelNames.indexOf(label),
    top,
    open: openId !== null && (labels.get(openId) ?? null) === label,
    renaming: label !== null && label === renaming,
    onFold: (folded) => props.onFold(label, folded),
    onRename: () => label !== null && props.onRename(label),
    onRenamed: props.onRenamed,
  });
}

const keyOf = (entry: LibraryEntry): string | number =>
  entry.kind === 'clip' ? entry.clip.id : `group ${entry.label ?? ''}`;

function rowsInSight(props: LibraryProps): TemplateResult {
  const { layout, openId } = props;
  const { first, end } = unevenWindow(layout.tops, props.scrollTop, props.viewHeight);
  const inSight = layout.entries.slice(first, end);
  const clips = inSight.flatMap((entry) => (entry.kind === 'clip' ? [entry.clip.id] : []));
  const stop = clips.find((id) => id === openId) ?? clips[0];
  const row = (entry: LibraryEntry, offset: number): TemplateResult => {
    const top = layout.tops[first + offset] ?? 0;
    return entry.kind === 'group'
      ? headRow(props, entry, top)
      : clipRow(props, entry, top, entry.clip.id === stop);
  };
  return html`${repeat(inSight, keyOf, row)}`;
}

function list(props: LibraryProps): TemplateResult {
  const {
    words: { t },
    layout,
    listed,
    filter,
  } = props;
  const onScroll = (event: Event): void => props.onScroll((event.target as HTMLElement).scrollTop);
  return html`<div class="library-list" @scroll=${onScroll} @keydown=${props.onListKey}>
    ${listed === 0 && filter ? html`<p class="library-nothing">${t('library.nothing', filter)}</p>` : nothing}
    <ul class="library-rows" ${styled({ height: `${heightOf(layout)}px` })}>
      ${rowsInSight(props)}
    </ul>
  </div>`;
}

function foot(props: LibraryProps): TemplateResult {
  const { words, ticked } = props;
  if (ticked.size > 0)
    return tickedBar({
      words,
      count: ticked.size,
      onLabel: props.onLabelTicked,
      onRemove: props.onRemoveTicked,
      onClear: props.onClearTicked,
    });
  return html`<div class="library-foot">
    ${icon('lock', 13)}<span>${words.t('library.local')}</span
    ><span class="library-size">${words.format.bytes(props.bytes)}</span>
  </div>`;
}

export function library(props: LibraryProps): TemplateResult {
  return html`
    <div class="library-head">${head(props)}${filterField(props)}</div>
    ${list(props)} ${foot(props)}
  `;
}
