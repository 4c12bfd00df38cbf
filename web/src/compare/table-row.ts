/** One row of the table in: a clip with what is known of it, or the head of a group; its cells out. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import type { MessageKey, Words } from '../app/i18n/catalogue';
import { icon } from '../common/icons';
import { labelMark } from '../common/label-mark';
import type { ClipId } from '../engine/types';
import { lengthText, reasonOf } from '../library/row';
import { nameLine, plainName } from './clip-words';
import { distanceNumber } from './distance-number';
import { columns, type ClipFacts, type Column, type GroupRow } from './table-rows';

export const labelListId = 'label-names';

/** What every row is drawn with. */
export interface RowProps {
  readonly words: Words;
  readonly labelNames: readonly string[];
  readonly checked: ReadonlySet<ClipId>;
  readonly aId: ClipId | null;
  readonly bId: ClipId | null;
  /** The row that the Tab key stops at. */
  readonly currentId: ClipId | null;
  readonly onChoose: (id: ClipId, as: 'a' | 'b') => void;
  /** `through`: with all rows from the one ticked before. */
  readonly onCheck: (id: ClipId, on: boolean, through: boolean) => void;
  readonly onLabel: (ids: readonly ClipId[], label: string) => void;
}

/** A column of ticks stands before. */
const width = columns.length + 1;

function groupTitle({ words, labelNames }: RowProps, group: GroupRow): TemplateResult {
  if (group.apart) return html`${words.t('table.apart')}`;
  if (group.label === null) return html`${words.t('names.no-label')}`;
  return html`${labelMark(labelNames.indexOf(group.label))}${group.label}`;
}

export function groupRow(props: RowProps, group: GroupRow, index: number): TemplateResult {
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

function labelCell(props: RowProps, { clip, name, label }: ClipFacts): TemplateResult {
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

function figureText({ words }: RowProps, facts: ClipFacts, column: Column): string {
  const { t, format } = words;
  const value = facts[column];
  if (value === null) return '–';
  if (typeof value === 'string') return plainName(value);
  if (column === 'length') return lengthText(words, value);
  if (column === 'rate') return t('unit.hertz', format.short(value, 2));
  return column === 'distance' ? distanceNumber(format, value) : format.integer(value);
}

const figureColumns = columns.filter((column) => column !== 'name' && column !== 'label');

function figureCells(props: RowProps, facts: ClipFacts): unknown {
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

export function clipRow(props: RowProps, facts: ClipFacts, index: number): TemplateResult {
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
