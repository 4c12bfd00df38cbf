/** A file name that loses its middle where room is short, and what tells it from its namesakes. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { splitName } from '../app/names';

/** The halves are two boxes, which would be read with a gap: the label speaks the name whole. */
export function clipName(name: string, qualifier = '', tailLength?: number): TemplateResult {
  const [head, tail] = splitName(name, tailLength);
  return html`<span
    class="clip-name"
    role="img"
    aria-label=${qualifier ? `${name} ${qualifier}` : name}
    title=${qualifier ? `${qualifier} ${name}` : name}
    ><span class="name-head">${head}</span><span class="name-tail">${tail}</span>${
      qualifier ? html`<span class="qualifier">${qualifier}</span>` : nothing
    }</span
  >`;
}
