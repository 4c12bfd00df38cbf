/** A label's place in the list in; its shape in its colour out. */
import { html, type TemplateResult } from 'lit-html';
import { labelLook } from './scene';
import { shapePath } from './label-shape';

const middle = 5;

export function swatch(label: number, size = 9): TemplateResult {
  const { colour, shape, open } = labelLook(label);
  return html`<svg
    class="swatch label-${colour} ${open ? 'open' : ''}"
    width=${size}
    height=${size}
    viewBox="0 0 10 10"
    aria-hidden="true"
  >
    <path d=${shapePath(shape, middle, middle, label < 0 ? 2 : 3.9)} />
  </svg>`;
}
