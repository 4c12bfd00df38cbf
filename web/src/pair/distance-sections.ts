/** What is known of the distance between A and B in; the sections of the panel that explain it out. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Context } from '../app/context';
import { componentBars } from '../compare/component-bars';
import { hasNegative, paintedBody, partList } from '../compare/painted-body';
import { whySentence } from '../compare/why-sentence';
import type { Explanation } from '../engine/comparison-types';
import { section } from '../inspector/section';
import { distanceText } from './distance-text';

const names = {
  a: html`<b class="pair-named" data-tint="0">A</b>`,
  b: html`<b class="pair-named" data-tint="1">B</b>`,
};

export function distanceSections(context: Context, found: Explanation | null): TemplateResult {
  const words = context.language.words.value;
  const { t } = words;
  const label = t('pair.distance');
  if (!found) return section({ label, body: html`<p class="pair-note">${missing(context)}</p>` });
  const { number, rank } = distanceText(context, found);
  const distance = html`<p class="pair-distance"><b>${number}</b> <span>${rank}</span></p>
    ${whySentence(words, found, names)}`;
  if (found.sentence.kind === 'same') return section({ label, body: distance });
  const { partShares } = found;
  const body = html`<div class="pair-parts">
      ${paintedBody(words, partShares)} ${partList(words, partShares)}
    </div>
    ${hasNegative(partShares) ? html`<p class="pair-note">${t('pair.parts.negative')}</p>` : nothing}`;
  return html`
    ${section({ label, body: distance })}
    ${section({ label: t('pair.twelve'), beside: t('pair.twelve.share'), body: componentBars(words, found.shares) })}
    ${section({ label: t('pair.parts'), body })}
  `;
}

function missing({ store, language }: Context): string {
  const { t, format } = language.words.value;
  const { openId, clips, compare } = store;
  const ids = [openId.value, compare.otherId.value].filter((id) => id !== null);
  if (ids.some((id) => clips.value[id]?.incomparable)) return t('pair.not-compared');
  const done = store.compare.comparing.value;
  if (done !== null) return t('pair.comparing', format.integer(Math.floor(100 * done)));
  return store.compare.comparison.value ? t('pair.not-compared') : t('pair.comparing', '0');
}
