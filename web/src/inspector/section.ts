/** What the sections of the side panel share: a title with something beside it, rows of label and value. */
import { html, nothing, type TemplateResult } from 'lit-html';

export interface Section {
  /** Its spoken name, and its title where that is nothing else. */
  readonly label: string;
  /** `false`: the section needs no title. */
  readonly title?: TemplateResult | false;
  readonly beside?: unknown;
  readonly body: unknown;
  /** Its numbers are those of an older decision. */
  readonly outdated?: boolean;
}

export function section({ label, title, beside, body, outdated }: Section): TemplateResult {
  const heading =
    title === false
      ? nothing
      : html`<h3>
          <span>${title ?? label}</span><span class="beside">${beside ?? nothing}</span>
        </h3>`;
  return html`<section class="inspector-section ${outdated ? 'outdated' : ''}" aria-label=${label}>
    ${heading}${body}
  </section>`;
}

export function fact(label: string, value: unknown): TemplateResult {
  return html`<div class="fact">
    <dt>${label}</dt>
    <dd>${value ?? nothing}</dd>
  </div>`;
}
