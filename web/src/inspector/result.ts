/** What the analysis found, in sentences, or why there was none. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import type { Anova, KeyposeResult, PerformerResult } from '../engine/types';
import { section } from './section';

/** Below this ratio of lowest kept to highest dropped intensity, the cut is called uncertain. */
const certainFrom = 1.5;

function sureness({ t, format }: Words, { sureness: ratio, keyposes }: KeyposeResult): string {
  if (keyposes.length === 0) return '';
  if (!Number.isFinite(ratio)) return t('result.certain');
  return t(ratio < certainFrom ? 'result.uncertain' : 'result.clear', format.decimal(ratio, 1));
}

function anova({ t, format }: Words, values: Anova | null): string {
  if (!values) return t('result.anova.none');
  const { betweenDegrees, withinDegrees, f, p } = values;
  const degrees = [betweenDegrees, withinDegrees].map(format.integer) as [string, string];
  return t('result.anova', ...degrees, format.decimal(f, 1), format.probability(p));
}

function sentences(words: Words, result: KeyposeResult): TemplateResult {
  const { t, format } = words;
  const zero = result.intensities.filter((intensity) => intensity === 0).length;
  const sentence = t(
    'result.sentence',
    t('result.candidates', result.candidates.length),
    t('result.zero', format.integer(zero)),
    t('result.clusters', result.clusters),
  );
  return html`<p class="result">
    <strong>${t('result.keyposes', result.keyposes.length)}</strong
    ><br />${sentence}<br />${anova(words, result.anova)}
  </p>`;
}

export function resultSection(
  words: Words,
  performer: PerformerResult,
  outdated: boolean,
): TemplateResult {
  const { keyposes, unanalysed } = performer;
  const beside = outdated
    ? words.t('result.updating')
    : keyposes
      ? sureness(words, keyposes)
      : nothing;
  const body = keyposes
    ? sentences(words, keyposes)
    : html`<p class="result">${unanalysed ? words.failure(unanalysed) : nothing}</p>`;
  return section(words.t('result.title'), beside, body, outdated ? 'outdated' : '');
}
