/** What is known of the distance and the timing of A and B in; the panel beside the stages out. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { section } from '../inspector/section';
import { tempoOf, type Timing } from './timing';
import { who } from './who';

export interface PairSideProps {
  readonly words: Words;
  readonly timings: readonly [Timing, Timing];
  readonly distance: TemplateResult;
}

function figureRow(name: string, a: string, b: string): TemplateResult {
  return html`<tr>
    <th scope="row">${name}</th>
    <td>${a}</td>
    <td>${b}</td>
  </tr>`;
}

function timing({ words, timings: [a, b] }: PairSideProps): TemplateResult {
  const { t, format } = words;
  const seconds = ({ betweenS }: Timing): string =>
    betweenS === null ? '–' : t('unit.seconds', format.decimal(betweenS, 2));
  const speed = ({ meanSpeed }: Timing): string =>
    meanSpeed === null ? '–' : format.decimal(meanSpeed, 2);
  const tempo = tempoOf(a, b);
  const sentence =
    tempo.kind === 'faster'
      ? t(`pair.timing.faster.${tempo.who}`, format.decimal(tempo.times, 1))
      : tempo.kind === 'same'
        ? t('pair.timing.same')
        : '';
  return html`<table class="pair-timing">
      <thead>
        <tr>
          <td></td>
          <th scope="col">${who('A', 0)}</th>
          <th scope="col">${who('B', 1)}</th>
        </tr>
      </thead>
      <tbody>
        ${figureRow(t('sort.keyposes'), format.integer(a.keyposes), format.integer(b.keyposes))}
        ${figureRow(t('pair.timing.between'), seconds(a), seconds(b))}
        ${figureRow(t('pair.timing.speed'), speed(a), speed(b))}
      </tbody>
    </table>
    <p class="pair-timing-sentence">
      ${sentence} ${a.meanSpeed === null && b.meanSpeed === null ? nothing : t('pair.timing.unit')}
    </p>`;
}

export function pairSide(props: PairSideProps): TemplateResult {
  const { t } = props.words;
  return html`${props.distance} ${section({ label: t('pair.timing'), body: timing(props) })}`;
}
