/** What the sections of the side panel share: a title with something beside it, rows of label and value. */
import { html, nothing, type TemplateResult } from 'lit-html';

export function section(title: string, beside: unknown, body: unknown, name = ''): TemplateResult {
  return html`<section class="inspector-section ${name}" aria-label=${title}>
    <h3><span>${title}</span><span class="beside">${beside}</span></h3>
    ${body}
  </section>`;
}

export function fact(label: string, value: unknown): TemplateResult {
  return html`<div class="fact">
    <dt>${label}</dt>
    <dd>${value ?? nothing}</dd>
  </div>`;
}
