/** A label's place among all, or −1 for none, in; its shape, or a small dot, out. */
import { html, type TemplateResult } from 'lit-html';
import { labelMark } from '../common/label-mark';

export const itemMark = (label: number): TemplateResult =>
  label < 0
    ? html`<svg
        class="label-mark none"
        width="12"
        height="12"
        viewBox="0 0 12 12"
        aria-hidden="true"
      >
        <circle cx="6" cy="6" r="2" />
      </svg>`
    : labelMark(label);
