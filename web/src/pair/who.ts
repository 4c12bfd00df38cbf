/** A clip's letter and its place in; its badge out. */
import { html, type TemplateResult } from 'lit-html';
import { tintOf } from '../figure/tints';

export function who(letter: string, place: number): TemplateResult {
  return html`<span class="who" data-tint=${String(tintOf(place))}>${letter}</span>`;
}
