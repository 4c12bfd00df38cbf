/** Why two clips differ in, and how the page names them; one plain sentence out. */
import '../styles/distance.css';
import { html, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { markedText } from '../common/marked-text';
import type { Explanation } from '../engine/comparison-types';
import { whyWords, type Component, type Mark } from './why-words';

/** σ with its axes below the line. */
export function sigma(component: Component): TemplateResult {
  return html`<span class="sigma">σ<sub>${component}</sub></span>`;
}

export function whySentence(
  words: Words,
  explanation: Explanation,
  names: Readonly<Record<'a' | 'b', TemplateResult>>,
): TemplateResult {
  const template = (mark: Mark): TemplateResult => {
    if (mark.kind === 'clip') return names[mark.which];
    return mark.kind === 'symbol' ? sigma(mark.component) : html`<b>${mark.text}</b>`;
  };
  const { text, marks } = whyWords(words, explanation);
  return html`<p class="distance-sentence">${markedText(text, marks.map(template))}</p>`;
}
