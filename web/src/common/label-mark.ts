/** The place of a label among all in; its shape in its colour out. The label's name stands beside it. */
import { html, type TemplateResult } from 'lit-html';
import { labelStyle } from '../app/labels';
import { shapePath } from './label-shape';

const boxPx = 12;
const radius = 4;

/** Nothing for -1: a label that is gone while scores of before still stand. */
export function labelMark(index: number): TemplateResult {
  if (index < 0) return html``;
  const { colour, shape, open } = labelStyle(index);
  const path = shapePath(shape, boxPx / 2, boxPx / 2, open ? radius - 0.6 : radius);
  return html`<svg
    class="label-mark ${colour.slice(2)} ${open ? 'open' : ''}"
    width=${boxPx}
    height=${boxPx}
    viewBox="0 0 ${boxPx} ${boxPx}"
    aria-hidden="true"
  >
    <path d=${path} />
  </svg>`;
}
