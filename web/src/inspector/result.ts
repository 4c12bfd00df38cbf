/** What the analysis found, in sentences, or why there was none. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import type { Anova, KeyposeResult, PerformerResult } from '../engine/types';
import { markedText, markFor } from '../common/marked-text';
import { section } from './section';

/** Below this ratio of lowest kept to highest dropped intensity, the cut is called uncertain. */
const certainFrom = 1.5;

const variable = (name: string): TemplateResult => html`<i class="variable">${name}</i>`;

function sureness({ t, format }: Words, { sureness: ratio, keyposes }: KeyposeResult): unknown {
  if (keyposes.length === 0) return nothing;
  const certain = !Number.isFinite(ratio);
  const value = format.decimal(ratio, 1);
  const text = certain
    ? t('result.certain')
    : t(ratio < certainFrom ? 'result.uncertain' : 'result.clear', value);
  const tip = certain ? t('result.certain.about') : t('result.cut.about', value);
  return html`<span class="sureness" data-tip=${tip}>${text}</span>`;
}

function anova({ t, format }: Words, values: Anova | null): unknown {
  if (!values) return t('result.anova.none');
  const { betweenDegrees, withinDegrees, f, p } = values;
  const degrees = [betweenDegrees, withinDegrees].map(format.integer) as [string, string];
  const numbers = [format.decimal(f, 1), markFor(1), format.probability(p)];
  return markedText(t('result.anova', markFor(0), ...degrees, ...numbers), [
    variable('F'),
    variable('p'),
  ]);
}

/** The count and the clusters stand out. */
function counts({ t, format }: Words, result: KeyposeResult): unknown {
  const zero = result.intensities.filter((intensity) => intensity === 0).length;
  const count = format.integer(result.candidates.length);
  const sentence = t(
    'result.sentence',
    t('result.candidates', result.candidates.length).replace(count, markFor(0)),
    t('result.zero', format.integer(zero)),
    markFor(1),
  );
  return markedText(sentence, [
    html`<strong>${count}</strong>`,
    html`<strong>${t('result.clusters', result.clusters)}</strong>`,
  ]);
}

export function resultSection(
  words: Words,
  { keyposes, unanalysed }: PerformerResult,
  outdated: boolean,
): TemplateResult {
  const { t } = words;
  const beside = outdated
    ? t('result.updating')
    : keyposes
      ? html`<span class="result-count">${t('result.keyposes', keyposes.keyposes.length)}</span>
          ${sureness(words, keyposes)}`
      : nothing;
  const body = keyposes
    ? html`<p class="result">${counts(words, keyposes)}<br />${anova(words, keyposes.anova)}</p>`
    : html`<p class="result">${unanalysed ? words.failure(unanalysed) : nothing}</p>`;
  return section({ label: t('result.title'), beside, body, outdated });
}
