/** What is known of the distance between A and B in; the sections of the panel that explain it out. */
import { html, type TemplateResult } from 'lit-html';
import type { Context } from '../app/context';
import type { Explanation } from '../engine/comparison-types';
import { section } from '../inspector/section';
import { distanceText } from './distance-text';

export function distanceSections(context: Context, found: Explanation | null): TemplateResult {
  const words = context.language.words.value;
  const label = words.t('pair.distance');
  if (!found) return section({ label, body: html`<p class="pair-note">${missing(context)}</p>` });
  const { number, rank } = distanceText(context, found);
  return section({
    label,
    body: html`<p class="pair-distance"><b>${number}</b> <span>${rank}</span></p>`,
  });
}

function missing({ store, language }: Context): string {
  const { t, format } = language.words.value;
  const done = store.compare.comparing.value;
  if (done !== null) return t('pair.comparing', format.integer(Math.floor(100 * done)));
  return store.compare.comparison.value ? t('pair.not-compared') : t('pair.comparing', '0');
}
