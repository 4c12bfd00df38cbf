/** The table on the page: props from the store, events to the actions, the row in focus kept in sight. */
import type { TemplateResult } from 'lit-html';
import type { Context } from '../app/context';
import type { ClipId } from '../engine/types';
import { scrollToRow } from '../library/row-window';
import { clipTable, tableRowHeightPx, type ClipTableProps } from './clip-table';
import { stepTo } from './table-rows';
import { check, checkAll, createTableState, sortBy, type TableState } from './table-state';
import type { Scrolling } from './scrolling';

/** The head of the table stays over its rows. */
const headHeightPx = 28;

function choose({ actions, compareActions }: Context, id: ClipId, as: 'a' | 'b'): void {
  if (as === 'a') actions.openClip(id);
  else compareActions.selectOther(id);
}

function goTo(state: TableState, index: number, scroll: HTMLElement): void {
  const row = state.rows.peek()[index];
  if (row?.kind !== 'clip') return;
  const { id } = row.facts.clip;
  state.current.value = id;
  const { scrollTop, clientHeight } = scroll;
  const height = clientHeight - headHeightPx;
  scroll.scrollTop = scrollToRow(index, tableRowHeightPx, scrollTop, height);
  // The row is drawn with the next frame.
  requestAnimationFrame(() =>
    requestAnimationFrame(() =>
      scroll.querySelector<HTMLElement>(`[data-row="${id}"]`)?.focus({ preventScroll: true }),
    ),
  );
}

function onKey(context: Context, state: TableState, event: KeyboardEvent): void {
  const target = event.target as HTMLElement;
  const scroll = event.currentTarget as HTMLElement;
  const row = target.dataset['row'];
  if (row === undefined) return;
  const id = Number(row);
  const next = stepTo(state.rows.peek(), id, event.key);
  if (next !== null) goTo(state, next, scroll);
  else if (event.key === 'Enter') choose(context, id, event.shiftKey ? 'b' : 'a');
  else if (event.key === ' ') check(state, id, !state.checked.peek().has(id), event.shiftKey);
  else if (event.key === 'F2')
    target.closest('tr')?.querySelector<HTMLInputElement>('.label-input')?.select();
  else return;
  event.preventDefault();
}

/** The row in focus, the open clip, or the first. */
function tabStop({ current, shown }: TableState, openId: ClipId | null): ClipId | null {
  const ids = shown.value;
  return [current.value, openId].find((id) => id !== null && ids.includes(id)) ?? ids[0] ?? null;
}

function propsOf(context: Context, state: TableState, scrolling: Scrolling): ClipTableProps {
  const { store, language, compareActions } = context;
  return {
    words: language.words.value,
    rows: state.rows.value,
    labelNames: store.labelNames.value,
    sort: state.sort.value,
    filter: state.filter.value,
    grouped: state.grouped.value,
    checked: state.checked.value,
    aId: store.openId.value,
    bId: store.compare.otherId.value,
    currentId: tabStop(state, store.openId.value),
    scrollTop: scrolling.top.value,
    viewHeight: scrolling.height.value,
    onSort: (column) => sortBy(state, column),
    onFilter: (filter) => (state.filter.value = filter),
    onGrouped: (grouped) => (state.grouped.value = grouped),
    onScroll: (top) => (scrolling.top.value = top),
    onKey: (event) => onKey(context, state, event),
    onChoose: (id, as) => {
      state.current.value = id;
      choose(context, id, as);
    },
    onCheck: (id, on, through) => check(state, id, on, through),
    onCheckAll: (on) => checkAll(state, on),
    onLabel: (ids, label) => compareActions.labelByHand(ids, label),
  };
}

export function createTableTab(context: Context, scrolling: Scrolling): () => TemplateResult {
  const state = createTableState(context);
  return () => clipTable(propsOf(context, state, scrolling));
}
