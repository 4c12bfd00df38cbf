/** Why the current keypose is one: its curve over the time scales, the parts of the body, its neighbours. */
import { html, nothing, svg, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { icon } from '../common/icons';
import type { KeyposeResult, PerformerResult } from '../engine/types';
import { barHeight, barPath, barWidth, partBars, type PartBar } from './part-bars';
import { section } from './section';
import { whyChart } from './why-chart';
import type { WhySubject } from './why-subject';

export interface WhyProps {
  readonly words: Words;
  readonly performer: PerformerResult;
  readonly frameTimeS: number;
  /** null: there is no keypose. */
  readonly subject: WhySubject | null;
  readonly hovered: number | null;
  readonly coarsestHz: number;
  readonly width: number;
  readonly outdated: boolean;
  readonly onHover: (candidate: number | null) => void;
  readonly onGo: (candidate: number) => void;
}

type Explained = WhyProps & { readonly subject: WhySubject; readonly keyposes: KeyposeResult };

function secondsOf(
  { words: { t, format }, keyposes, frameTimeS }: Explained,
  candidate: number,
): string {
  const seconds = (keyposes.candidates[candidate] ?? 0) * frameTimeS;
  // Four digits before the point leave no room for two behind it.
  return t('unit.seconds', format.decimal(seconds, seconds < 1000 ? 2 : 0));
}

function bar({ percent, side }: PartBar): TemplateResult {
  return svg`<line class="bar-zero" x1=${barWidth / 2} x2=${barWidth / 2} y1="0" y2=${barHeight} />
    ${percent === null ? nothing : svg`<path class="bar-${side}" d=${barPath(percent)} />`}`;
}

function partRow({ t, format }: Words, row: PartBar): TemplateResult {
  const { percent } = row;
  const sign =
    percent === null ? '' : Math.round(percent) < 0 ? '−' : Math.round(percent) > 0 ? '+' : '';
  const value =
    percent === null ? '–' : t('unit.percent', sign + format.integer(Math.abs(percent)));
  return html`<tr>
    <th scope="row">${t(`part.${row.part}`)}</th>
    <td class="part-bar">
      <svg viewBox="0 0 ${barWidth} ${barHeight}" aria-hidden="true">${bar(row)}</svg>
    </td>
    <td class="part-percent">${value}</td>
  </tr>`;
}

function bodyParts({
  words,
  performer,
  keyposes,
  subject,
}: Explained): TemplateResult | typeof nothing {
  const { t } = words;
  if (performer.body.kind !== 'human') return html`<p class="why-words">${t('why.not-human')}</p>`;
  if (subject.keypose === null) return nothing;
  const rows = partBars(keyposes.bodyPartPercents, subject.keypose);
  if (rows.length === 0) return nothing;
  return html`<table class="parts">
    <caption class="spoken">
      ${t('why.parts')}
    </caption>
    <tbody>
      ${rows.map((row) => partRow(words, row))}
    </tbody>
  </table>`;
}

function sentence({
  words: { t, format, language },
  performer,
  keyposes,
  subject,
}: Explained): TemplateResult {
  const scale = keyposes.strongestScales[subject.candidate] ?? -1;
  const hz = format.decimal(keyposes.scalesHz[scale] ?? 0, 1);
  const strongest = scale < 0 ? '' : t('why.strongest', hz);
  const human = performer.body.kind === 'human' && keyposes.bodyPartPercents.length > 0;
  const dropped = keyposes.cut === null ? '' : t('why.dropped', format.decimal(keyposes.cut, 1));
  const more = subject.keypose === null ? dropped : human ? t('why.parts') : '';
  return html`<p class="why-words">
    ${[strongest, more].filter(Boolean).join(language === 'ja' ? '' : ' ')}
  </p>`;
}

function neighbour(props: Explained, which: 'stronger' | 'weaker'): TemplateResult {
  const { words, keyposes, subject, onGo } = props;
  const { t, format } = words;
  const candidate = subject[which];
  const seconds = candidate === null ? '' : secondsOf(props, candidate);
  const intensity =
    candidate === null ? '' : format.decimal(keyposes.intensities[candidate] ?? 0, 1);
  return html`<button
    type="button"
    class="button line"
    data-tip=${candidate === null ? nothing : t(`why.${which}.about`, intensity)}
    ?disabled=${candidate === null}
    @click=${() => candidate !== null && onGo(candidate)}
  >
    ${icon(which === 'stronger' ? 'arrow-up' : 'arrow-down', 14)}<span
      >${t(`why.${which}`)} <span class="button-value">${seconds}</span></span
    >
  </button>`;
}

function explained(props: Explained): TemplateResult {
  const { words, keyposes, subject, hovered, coarsestHz, width, onHover, onGo } = props;
  const { candidate } = subject;
  return html`${whyChart({ words, keyposes, candidate, hovered, coarsestHz, width, onHover, onGo })}
    ${sentence(props)} ${bodyParts(props)}
    <div class="button-row" role="group" aria-label=${words.t('why.neighbours')}>
      ${neighbour(props, 'stronger')}${neighbour(props, 'weaker')}
    </div>`;
}

function title(props: Explained): TemplateResult {
  const {
    words: { t, format },
    subject,
  } = props;
  const name =
    subject.keypose === null
      ? html`<span>${t('why.candidate')}</span>`
      : html`<span class="why-name"
          >${t('why.keypose', format.integer(subject.keypose + 1))}</span
        >`;
  return html`${name} <span class="why-time">${secondsOf(props, subject.candidate)}</span>`;
}

function intensity({ words: { t, format }, keyposes, subject }: Explained): string {
  const value = format.decimal(keyposes.intensities[subject.candidate] ?? 0, 1);
  return subject.rank === null
    ? t('why.intensity', value)
    : t('why.intensity.rank', value, format.integer(subject.rank));
}

export function whySection(props: WhyProps): TemplateResult {
  const {
    words: { t },
    performer,
    subject,
    outdated,
  } = props;
  const { keyposes } = performer;
  const label = t('why.title');
  if (!keyposes || !subject) {
    const reason = t(keyposes ? 'why.none' : 'why.unanalysed');
    return section({ label, body: html`<p class="quiet">${reason}</p>`, outdated });
  }
  const whole = { ...props, keyposes, subject };
  return section({
    label,
    title: title(whole),
    beside: intensity(whole),
    body: explained(whole),
    outdated,
  });
}
