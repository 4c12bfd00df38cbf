/** The tab "Table": every clip as a row, those that cannot be compared with their reason; also what the map says, to be read. */
import '../styles/clip-table.css';
import { html, nothing, type TemplateResult } from 'lit-html';
import { repeat } from 'lit-html/directives/repeat.js';
import { live } from 'lit-html/directives/live.js';
import type { MessageKey, Words } from '../app/i18n/catalogue';
import { iconButton } from '../common/buttons';
import { styled } from '../common/directives';
import { icon } from '../common/icons';
import { labelMark } from '../common/label-mark';
import type { ClipId } from '../engine/types';
import { lengthText, reasonOf } from '../library/row';
import { rowWindow } from '../library/row-window';
import { nameLine, plainName } from './clip-words';
import { distanceNumber } from './distance-number';
import {
  columns,
  type ClipFacts,
  type Column,
  type GroupRow,
  type TableRow,
  type TableSort,
} from './table-rows';

export const tableRowHeightPx = 28;
export const labelListId = 'label-names';
/** Labels offered while one is written. */
const mostOffered = 200;

export interface ClipTableProps {
  readonly words: Words;
  readonly rows: readonly TableRow[];
  readonly labelNames: readonly string[];
  readonly sort: TableSort;
  readonly filter: string;
  readonly grouped: boolean;
  readonly checked: ReadonlySet<ClipId>;
  readonly aId: ClipId | null;
  readonly bId: ClipId | null;
  /** The row that the Tab key stops at. */
  readonly currentId: ClipId | null;
  readonly scrollTop: number;
  readonly viewHeight: number;
  readonly onSort: (column: Column) => void;
  readonly onFilter: (filter: string) => void;
  readonly onGrouped: (grouped: boolean) => void;
  readonly onScroll: (top: number) => void;
  readonly onKey: (event: KeyboardEvent) => void;
  readonly onChoose: (id: ClipId, as: 'a' | 'b') => void;
  /** `through`: with all rows from the one ticked before. */
  readonly onCheck: (id: ClipId, on: boolean, through: boolean) => void;
  readonly onCheckAll: (on: boolean) => void;
  readonly onLabel: (ids: readonly ClipId[], label: string) => void;
}

/** A column of ticks stands before. */
const width = columns.length + 1;

function tools(props: ClipTableProps): TemplateResult {
  const { words, filter, grouped, onFilter, onGrouped } = props;
  const { t } = words;
  return html`<div class="table-tools">
    <div class="field">
      ${icon('search', 14)}
      <input
        type="text"
        autocomplete="off"
        spellcheck="false"
        aria-label=${t('table.filter')}
        placeholder=${t('table.filter')}
        .value=${live(filter)}
        @input=${(event: Event) => onFilter((event.target as HTMLInputElement).value)}
      />
      ${filter ? iconButton({ name: 'x', label: t('library.filter.clear'), size: 14, small: true, onPress: () => onFilter('') }) : nothing}
    </div>
    <button
      type="button"
      class="button line ${grouped ? 'on' : ''}"
      aria-pressed=${String(grouped)}
      @click=${() => onGrouped(!grouped)}
    >
      ${t('table.group')}
    </button>
  </div>`;
}

/** What is written holds for all rows that are ticked. */
function labelling({ words: { t }, checked, onLabel, onCheckAll }: ClipTableProps): TemplateResult {
  const onSubmit = (event: Event): void => {
    event.preventDefault();
    const field = (event.target as HTMLFormElement).querySelector('input');
    onLabel([...checked], field?.value.trim() ?? '');
    if (field) field.value = '';
    onCheckAll(false);
  };
  if (checked.size === 0) return html`<p class="table-labelling quiet">${t('table.about')}</p>`;
  return html`<form class="table-labelling" @submit=${onSubmit}>
    <label for="label-by-hand">${t('table.label-ticked', checked.size)}</label>
    <div class="field">
      <input id="label-by-hand" type="text" autocomplete="off" list=${labelListId} />
    </div>
    <button type="submit" class="button line">${t('labels.apply')}</button>
  </form>`;
}

function columnHead(
  { words: { t }, sort, onSort }: ClipTableProps,
  column: Column,
): TemplateResult {
  const sorted = column === sort.column;
  const direction = sort.descending ? 'descending' : 'ascending';
  return html`<th scope="col" class="column-${column}" aria-sort=${sorted ? direction : nothing}>
    <button type="button" class="column-sort" @click=${() => onSort(column)}>
      ${t(`table.${column}`)}${sorted ? icon(sort.descending ? 'arrow-down' : 'arrow-up', 12) : nothing}
    </button>
  </th>`;
}

function head(props: ClipTableProps): TemplateResult {
  const { words, rows, checked, onCheckAll } = props;
  const clips = rows.filter(({ kind }) => kind === 'clip').length;
  const all = clips > 0 && checked.size >= clips;
  return html`<thead>
    <tr aria-rowindex="1">
      <th class="column-tick">
        <input
          type="checkbox"
          aria-label=${words.t('table.tick-all')}
          .checked=${live(all)}
          .indeterminate=${live(!all && checked.size > 0)}
          @change=${(event: Event) => onCheckAll((event.target as HTMLInputElement).checked)}
        />
      </th>
      ${columns.map((column) => columnHead(props, column))}
    </tr>
  </thead>`;
}

function groupTitle({ words, labelNames }: ClipTableProps, group: GroupRow): TemplateResult {
  if (group.apart) return html`${words.t('table.apart')}`;
  if (group.label === null) return html`${words.t('names.no-label')}`;
  return html`${labelMark(labelNames.indexOf(group.label))}${group.label}`;
}

function groupRow(props: ClipTableProps, group: GroupRow, index: number): TemplateResult {
  return html`<tr class="group" aria-rowindex=${index + 2}>
    <th scope="rowgroup" colspan=${width}>
      <span class="group-title"
        >${groupTitle(props, group)}<span class="quiet"
          >${props.words.format.integer(group.count)}</span
        ></span
      >
    </th>
  </tr>`;
}

const changeKeys = ['Enter', 'Escape'];

function labelCell(props: ClipTableProps, { clip, name, label }: ClipFacts): TemplateResult {
  const { words, labelNames, currentId, onLabel } = props;
  const onChange = (event: Event): void => {
    const field = event.target as HTMLInputElement;
    field.value = field.value.trim();
    onLabel([clip.id], field.value);
  };
  const onKey = (event: KeyboardEvent): void => {
    event.stopPropagation();
    if (!changeKeys.includes(event.key)) return;
    const field = event.target as HTMLInputElement;
    if (event.key === 'Escape') field.value = label ?? '';
    event.preventDefault();
    field.blur();
    field.closest('tr')?.querySelector<HTMLElement>('.table-name')?.focus();
  };
  return html`<td class="column-label">
    <span
      >${label === null ? nothing : labelMark(labelNames.indexOf(label))}<input
        class="label-input"
        type="text"
        autocomplete="off"
        list=${labelListId}
        aria-label=${words.t('table.label-of', name)}
        placeholder="–"
        tabindex=${clip.id === currentId ? 0 : -1}
        .value=${label ?? ''}
        .defaultValue=${label ?? ''}
        @change=${onChange}
        @keydown=${onKey}
    /></span>
  </td>`;
}

function figureText({ words }: ClipTableProps, facts: ClipFacts, column: Column): string {
  const { t, format } = words;
  const value = facts[column];
  if (value === null) return '–';
  if (typeof value === 'string') return plainName(value);
  if (column === 'length') return lengthText(words, value);
  if (column === 'rate') return t('unit.hertz', format.short(value, 2));
  return column === 'distance' ? distanceNumber(format, value) : format.integer(value);
}

const figureColumns = columns.filter((column) => column !== 'name' && column !== 'label');

function figureCells(props: ClipTableProps, facts: ClipFacts): unknown {
  const { words, onChoose } = props;
  const { clip, nearestId } = facts;
  if (facts.apart) {
    const reason = clip.failure
      ? reasonOf(words, clip)
      : clip.incomparable
        ? words.failure(clip.incomparable)
        : '';
    return html`<td class="reason" colspan=${figureColumns.length} title=${reason}>
      <span>${icon(clip.status === 'failed' ? 'octagon-x' : 'info', 13)}${reason}</span>
    </td>`;
  }
  return figureColumns.map((column) => {
    const text = figureText(props, facts, column);
    if (column !== 'nearest' || nearestId === null)
      return html`<td class="column-${column}">${text}</td>`;
    const onPress = (): void => {
      onChoose(clip.id, 'a');
      onChoose(nearestId, 'b');
    };
    return html`<td class="column-nearest">
      <button type="button" class="row-nearest" tabindex="-1" @click=${onPress}>
        ${nameLine(text)}
      </button>
    </td>`;
  });
}

const letters: Readonly<Record<'a' | 'b', MessageKey>> = { a: 'table.a', b: 'table.b' };

function clipRow(props: ClipTableProps, facts: ClipFacts, index: number): TemplateResult {
  const { words, checked, aId, bId, currentId, onChoose, onCheck } = props;
  const { clip, name } = facts;
  const which = clip.id === aId ? 'a' : clip.id === bId ? 'b' : null;
  const ticked = checked.has(clip.id);
  return html`<tr
    class="${which ? 'chosen' : ''} ${facts.apart ? 'apart' : ''}"
    aria-rowindex=${index + 2}
    aria-selected=${String(which !== null)}
  >
    <td class="column-tick">
      <input
        type="checkbox"
        tabindex=${clip.id === currentId ? 0 : -1}
        aria-label=${words.t('table.tick', name)}
        .checked=${live(ticked)}
        @click=${(event: MouseEvent) => onCheck(clip.id, !ticked, event.shiftKey)}
      />
    </td>
    <th scope="row" class="column-name">
      <button
        type="button"
        class="table-name"
        data-row=${clip.id}
        tabindex=${clip.id === currentId ? 0 : -1}
        @click=${(event: MouseEvent) => onChoose(clip.id, event.shiftKey ? 'b' : 'a')}
      >
        ${nameLine(plainName(name))}${which ? html`<b class="letter-${which}">${words.t(letters[which])}</b>` : nothing}
      </button>
    </th>
    ${labelCell(props, facts)}${figureCells(props, facts)}
  </tr>`;
}

const spacer = (rows: number): TemplateResult | typeof nothing =>
  rows > 0
    ? html`<tr
        class="spacer"
        aria-hidden="true"
        ${styled({ height: `${rows * tableRowHeightPx}px` })}
      ></tr>`
    : nothing;

function body(props: ClipTableProps): TemplateResult {
  const { rows, scrollTop, viewHeight } = props;
  const { first, end } = rowWindow(rows.length, tableRowHeightPx, scrollTop, viewHeight);
  const key = (row: TableRow): string =>
    row.kind === 'clip' ? String(row.facts.clip.id) : `${row.apart} ${row.label}`;
  const draw = (row: TableRow, offset: number): TemplateResult =>
    row.kind === 'clip'
      ? clipRow(props, row.facts, first + offset)
      : groupRow(props, row, first + offset);
  return html`<tbody>
    ${spacer(first)}${repeat(rows.slice(first, end), key, draw)}${spacer(rows.length - end)}
  </tbody>`;
}

export function clipTable(props: ClipTableProps): TemplateResult {
  const { words, rows, labelNames, filter } = props;
  const onScroll = (event: Event): void => props.onScroll((event.target as HTMLElement).scrollTop);
  return html`${tools(props)}${labelling(props)}
    <datalist id=${labelListId}>
      ${labelNames.slice(0, mostOffered).map((name) => html`<option value=${name}></option>`)}
    </datalist>
    <div class="table-scroll" @scroll=${onScroll} @keydown=${props.onKey}>
      <table
        class="clip-table"
        role="grid"
        aria-rowcount=${rows.length + 1}
        aria-label=${words.t('table.name-of')}
      >
        ${head(props)}${body(props)}
      </table>
      ${rows.length === 0 && filter ? html`<p class="side-hint">${words.t('library.nothing', filter)}</p>` : nothing}
    </div>`;
}
