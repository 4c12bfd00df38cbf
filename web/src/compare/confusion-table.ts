/** Own label against the label of the nearest in; a table of counts out, its right ones on the diagonal. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { styled } from '../common/directives';
import { labelMark } from '../common/label-mark';
import type { Evaluation } from '../engine/comparison-types';

export interface ConfusionProps {
  readonly words: Words;
  readonly evaluation: Evaluation;
  /** Place of a label among all: its colour and shape. */
  readonly placeOf: (label: string) => number;
  readonly onCell: (own: number, found: number) => void;
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

export function confusionCell(
  { confusion, labels }: Pick<Evaluation, 'confusion' | 'labels'>,
  own: number,
  found: number,
): ConfusionCell {
  const row = confusion.subarray(own * labels.length, (own + 1) * labels.length);
  const count = row[found] ?? 0;
  const share =
    count /
    Math.max(
      1,
      row.reduce((sum, value) => sum + value, 0),
    );
  const paint = Math.round(leastPaint + (mostPaint - leastPaint) * share);
  if (count === 0) return { count, kind: 'none', paint: 0 };
  if (own !== found) return { count, kind: 'wrong', paint };
  return { count, kind: share > inverted ? 'strong' : 'right', paint };
}

function cellOf(props: ConfusionProps, own: number, found: number): TemplateResult {
  const { words, evaluation, onCell } = props;
  const { labels } = evaluation;
  const { count, kind, paint } = confusionCell(evaluation, own, found);
  const text = words.format.integer(count);
  if (kind === 'none') return html`<td class="cell-none"><span class="spoken">0</span></td>`;
  if (kind !== 'wrong')
    return html`<td class="cell-${kind}" ${styled({ '--paint': `${paint}%` })}>${text}</td>`;
  const about = words.t('evaluation.taken-for', labels[own] ?? '', labels[found] ?? '');
  return html`<td class="cell-wrong">
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

export function confusionTable(props: ConfusionProps): TemplateResult {
  const { words, evaluation, placeOf } = props;
  const { labels } = evaluation;
  const head = (label: string): TemplateResult =>
    html`<th scope="col" title=${label}>
      ${labelMark(placeOf(label))}<span class="spoken">${label}</span>
    </th>`;
  const row = (label: string, own: number): TemplateResult =>
    html`<tr>
      <th scope="row" title=${label}>
        <span>${labelMark(placeOf(label))}<span class="label-name">${label}</span></span>
      </th>
      ${labels.map((_, found) => cellOf(props, own, found))}
    </tr>`;
  return html`<table class="confusion">
    <caption class="spoken">
      ${words.t('evaluation.confusion')}
    </caption>
    <thead>
      <tr>
        <td>${nothing}</td>
        ${labels.map(head)}
      </tr>
    </thead>
    <tbody>
      ${labels.map(row)}
    </tbody>
  </table>`;
}
