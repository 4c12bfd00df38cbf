/** The clips at their moments in; the names of the rows beside them out. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { clipName } from '../common/clip-name';
import { styled } from '../common/directives';
import { bodyParts } from '../engine/types';
import type { PairClip } from './pair-clips';
import { partRow, rows, type RowPlace } from './rows-layout';
import { who } from './who';

export interface RowLabelProps {
  readonly words: Words;
  readonly a: PairClip;
  readonly b: PairClip;
  /** Motion speeds at the moments shown; null where there is none. */
  readonly speeds: readonly [number | null, number | null];
  /** "warped", "from the start". */
  readonly alignment: string;
}

const at = (top: number) => styled({ top: `${top}px` });

function clipLabel({ top }: RowPlace, clip: PairClip, { t, format }: Words): TemplateResult {
  const lengthS = (clip.frames - 1) * clip.frameTimeS;
  return html`<div class="pair-row-clip" ${at(top + 6)}>
    <span class="pair-row-name">${who(clip.letter, clip.place)} <b>${clipName(clip.name)}</b></span>
    ${clip.qualifier === '' ? nothing : html`<span class="pair-row-note">${clip.qualifier}</span>`}
    <span class="pair-row-note">${t('unit.seconds', format.decimal(lengthS, 2))}</span>
  </div>`;
}

function label({ top }: RowPlace, text: string, figure = '', offset = 2): TemplateResult {
  return html`<div class="pair-row-label" ${at(top + offset)}>
    <span>${text}</span><span class="pair-row-figure">${figure}</span>
  </div>`;
}

function warpedRows({ words: { t } }: RowLabelProps) {
  return html`${label(rows.ahead, t('pair.ahead'), '', 5)}
    <div class="pair-row-note" ${at(rows.ahead.top + 24)}>${t('pair.ahead.unit')}</div>
    ${bodyParts.map(
      (part, i) =>
        html`<div class="pair-part-label" ${at(partRow(i).top - 1)}>${t(`part.${part}`)}</div>`,
    )}`;
}

export function rowLabels(props: RowLabelProps): TemplateResult {
  const { words, a, b, speeds, alignment } = props;
  const { t, format } = words;
  const speed = (value: number | null): string => (value === null ? '' : format.decimal(value, 1));
  return html`
    ${clipLabel(rows.stripA, a, words)} ${label(rows.pinsA, t('timeline.pins'))}
    ${label(rows.speedA, t('timeline.speed'), speed(speeds[0]), 6)}
    ${label(rows.ribbon, t('pair.alignment'), alignment, 22)}
    ${label(rows.speedB, t('timeline.speed'), speed(speeds[1]), 6)}
    ${label(rows.pinsB, t('timeline.pins'))} ${clipLabel(rows.stripB, b, words)}
    ${warpedRows(props)}
  `;
}
