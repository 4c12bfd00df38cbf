/** Own label against the label of the nearest in; a table of counts out, its right ones on the diagonal. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { styled } from '../common/directives';
import { labelMark } from '../common/label-mark';
import type { Evaluation } from '../engine/comparison-types';
import { confusionExtent, confusionWindow, mostWhole, type Room } from './confusion-window';

export interface ConfusionProps {
  readonly words: Words;
  readonly evaluation: Evaluation;
  readonly counts: ConfusionCounts;
  /** Where it is scrolled to, and how much of it there is room for. */
  readonly room: Room;
  /** Place of a label among all: its colour and shape. */
  readonly placeOf: (label: string) => number;
  readonly onCell: (own: number, found: number) => void;
  readonly onScroll: (left: number, top: number) => void;
}

const leastPaint = 20;
const mostPaint = 90;
/** From here on the paint is too strong for the page's ink. */
const inverted = 0.5;

export interface ConfusionCell {
  readonly count: number;
  readonly kind: 'none' | 'right' | 'strong' | 'wrong';
  /** Percent of colour, by the part of its row. */
  readonly paint: number;
}

/** The fields by row and column, and the sum of every row. */
export class ConfusionCounts {
  private readonly counts = new Map<number, number>();
  private readonly rows: Float64Array;
  private readonly labels: number;

  constructor({ confusion, labels }: Pick<Evaluation, 'confusion' | 'labels'>) {
    this.labels = labels.length;
    this.rows = new Float64Array(this.labels);
    for (const [own, found, count] of confusion) {
      this.counts.set(own * this.labels + found, count);
      this.rows[own] += count;
    }
  }

  cell(own: number, found: number): ConfusionCell {
    const count = this.counts.get(own * this.labels + found) ?? 0;
    if (count === 0) return { count, kind: 'none', paint: 0 };
    const share = count / Math.max(1, this.rows[own]);
    const paint = Math.round(leastPaint + (mostPaint - leastPaint) * share);
    if (own !== found) return { count, kind: 'wrong', paint };
    return { count, kind: share > inverted ? 'strong' : 'right', paint };
  }
}

function cellOf(props: ConfusionProps, own: number, found: number): TemplateResult {
  const { words, evaluation, counts, onCell } = props;
  const { labels } = evaluation;
  const { count, kind, paint } = counts.cell(own, found);
  const text = words.format.integer(count);
  const column = found + 2;
  if (kind === 'none')
    return html`<td class="cell-none" aria-colindex=${column}><span class="spoken">0</span></td>`;
  if (kind !== 'wrong')
    return html`<td
      class="cell-${kind}"
      aria-colindex=${column}
      ${styled({ '--paint': `${paint}%` })}
    >
      ${text}
    </td>`;
  const about = words.t('evaluation.taken-for', labels[own] ?? '', labels[found] ?? '');
  return html`<td class="cell-wrong" aria-colindex=${column}>
    <button
      type="button"
      title=${about}
      aria-label="${text}, ${about}"
      @click=${() => onCell(own, found)}
    >
      ${text}
    </button>
  </td>`;
}

const range = (first: number, count: number): number[] =>
  Array.from({ length: count }, (_, index) => first + index);

function table(props: ConfusionProps): TemplateResult {
  const { words, evaluation, placeOf, room } = props;
  const { labels } = evaluation;
  const shown = confusionWindow(labels.length, room);
  const columns = range(shown.firstColumn, shown.columnCount);
  const name = (index: number): string => labels[index] ?? '';
  const head = (found: number): TemplateResult =>
    html`<th scope="col" title=${name(found)} aria-colindex=${found + 2}>
      ${labelMark(placeOf(name(found)))}<span class="spoken">${name(found)}</span>
    </th>`;
  const row = (own: number): TemplateResult =>
    html`<tr aria-rowindex=${own + 2}>
      <th scope="row" title=${name(own)} aria-colindex="1">
        <span>${labelMark(placeOf(name(own)))}<span class="label-name">${name(own)}</span></span>
      </th>
      ${columns.map((found) => cellOf(props, own, found))}
    </tr>`;
  return html`<table
    class="confusion"
    aria-rowcount=${labels.length + 1}
    aria-colcount=${labels.length + 1}
  >
    <caption class="spoken">
      ${words.t('evaluation.confusion')}
    </caption>
    <thead>
      <tr aria-rowindex="1">
        <td aria-colindex="1">${nothing}</td>
        ${columns.map(head)}
      </tr>
    </thead>
    <tbody>
      ${range(shown.firstRow, shown.rowCount).map(row)}
    </tbody>
  </table>`;
}

export function confusionTable(props: ConfusionProps): TemplateResult {
  const { labels } = props.evaluation;
  if (labels.length <= mostWhole) return table(props);
  const { width, height } = confusionExtent(labels.length);
  const onScroll = (event: Event): void => {
    const { scrollLeft, scrollTop } = event.currentTarget as HTMLElement;
    props.onScroll(scrollLeft, scrollTop);
  };
  const { room } = props;
  return html`<div
    class="confusion-scroll"
    ${styled({ width: `${room.width}px`, height: `${room.height}px` })}
    @scroll=${onScroll}
  >
    <div class="confusion-extent" ${styled({ width: `${width}px`, height: `${height}px` })}>
      ${table(props)}
    </div>
  </div>`;
}
