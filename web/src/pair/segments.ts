/** Choices of which one holds in; a row of buttons out, the one that holds pressed. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { icon, type IconName } from '../common/icons';
import '../styles/segments.css';

export interface Segment {
  readonly label: string;
  readonly tip?: string;
  readonly icon?: IconName;
  readonly chosen: boolean;
  readonly onChoose: () => void;
}

export function segments(label: string, all: readonly Segment[]): TemplateResult {
  return html`<span class="segments" role="group" aria-label=${label}>
    ${all.map(
      (one) =>
        html`<button
          type="button"
          class=${one.chosen ? 'on' : ''}
          aria-pressed=${String(one.chosen)}
          data-tip=${one.tip ?? nothing}
          @click=${one.onChoose}
        >
          ${one.icon ? icon(one.icon, 14) : nothing}<span>${one.label}</span>
        </button>`,
    )}
  </span>`;
}
