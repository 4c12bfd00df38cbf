/** What a person does with the table besides choosing clips: sort, filter, groups, ticks; rows from them. */
import { computed, signal, type ReadonlySignal, type Signal } from '@preact/signals-core';
import type { Context } from '../app/context';
import type { ClipId } from '../engine/types';
import { clipFacts, tableRows, type Column, type TableRow, type TableSort } from './table-rows';

export interface TableState {
  readonly sort: Signal<TableSort>;
  readonly filter: Signal<string>;
  readonly grouped: Signal<boolean>;
  readonly checked: Signal<ReadonlySet<ClipId>>;
  /** The row that the keys are at. */
  readonly current: Signal<ClipId | null>;
  readonly rows: ReadonlySignal<readonly TableRow[]>;
  /** The clips of the rows, from top to bottom. */
  readonly shown: ReadonlySignal<readonly ClipId[]>;
}

export function createTableState({ store }: Context): TableState {
  const sort = signal<TableSort>({ column: 'name', descending: false });
  const filter = signal('');
  const grouped = signal(false);
  const facts = computed(() =>
    clipFacts({
      clips: store.present.value,
      qualifiers: store.qualifiers.value,
      labels: store.labels.value,
      comparison: store.compare.comparison.value,
      cut: store.compare.cut.value,
    }),
  );
  const rows = computed(() =>
    tableRows(facts.value, {
      sort: sort.value,
      filter: filter.value,
      grouped: grouped.value,
      labelNames: store.labelNames.value,
    }),
  );
  return {
    sort,
    filter,
    grouped,
    checked: store.ticked,
    current: signal<ClipId | null>(null),
    rows,
    shown: computed(() =>
      rows.value.flatMap((row) => (row.kind === 'clip' ? [row.facts.clip.id] : [])),
    ),
  };
}

/** A second press on a column turns it round. */
export function sortBy({ sort }: TableState, column: Column): void {
  const before = sort.peek();
  sort.value = { column, descending: before.column === column && !before.descending };
}

/** Ticks one row, or all from the one ticked before to this one. */
export function check(
  { checked, current, shown }: TableState,
  id: ClipId,
  on: boolean,
  through: boolean,
): void {
  const ids = shown.peek();
  const from = through ? ids.indexOf(current.peek() ?? id) : -1;
  const to = ids.indexOf(id);
  const range = from < 0 ? [id] : ids.slice(Math.min(from, to), Math.max(from, to) + 1);
  const next = new Set(checked.peek());
  for (const one of range) {
    if (on) next.add(one);
    else next.delete(one);
  }
  checked.value = next;
  current.value = id;
}

export function checkAll({ checked, shown }: TableState, on: boolean): void {
  checked.value = new Set(on ? shown.peek() : []);
}
