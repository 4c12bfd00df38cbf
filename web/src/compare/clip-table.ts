/** The tab "Table": the filter, the label of what is ticked, and every clip as a row; also what the map says, to be read. */
import '../styles/clip-table.css';
import { html, nothing, type TemplateResult } from 'lit-html';
import { repeat } from 'lit-html/directives/repeat.js';
import { live } from 'lit-html/directives/live.js';
import { iconButton } from '../common/buttons';
import { styled } from '../common/directives';
import { icon } from '../common/icons';
import { rowWindow } from '../library/row-window';
import { clipRow, groupRow, labelListId, type RowProps } from './table-row';
import { columns, type Column, type TableRow, type TableSort } from './table-rows';

export const tableRowHeightPx = 28;
/** Labels offered while one is written. */
const mostOffered = 200;

export interface ClipTableProps extends RowProps {
  readonly rows: readonly TableRow[];
  readonly sort: TableSort;
  readonly filter: string;
  readonly grouped: boolean;
  readonly scrollTop: number;
  readonly viewHeight: number;
  readonly onSort: (column: Column) => void;
  readonly onFilter: (filter: string) => void;
  readonly onGrouped: (grouped: boolean) => void;
  readonly onScroll: (top: number) => void;
  readonly onKey: (event: KeyboardEvent) => void;
  readonly onCheckAll: (on: boolean) => void;
}

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
