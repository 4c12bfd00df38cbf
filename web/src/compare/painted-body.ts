/** Shares of the parts of a body in; a standing figure painted by them out, and a list of them. */
import '../styles/distance.css';
import { html, svg, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { styled } from '../common/directives';
import { bodyParts, type BodyPart } from '../engine/types';
import { partOutlines, trunkOutline } from './body-outline';

export type PartShares = Readonly<Record<BodyPart, number>>;

/** Of the colour for the largest share, in percent; nothing for none or less than none. */
const leastPaint = 18;

export function paintPercent(share: number, largest: number): number {
  if (share <= 0 || largest <= 0) return 0;
  return leastPaint + (100 - leastPaint) * (share / largest);
}

const percentOf = (share: number): number => Math.round(share * 100);

/** Whether one is listed below zero. */
export const hasNegative = (shares: PartShares): boolean =>
  bodyParts.some((part) => percentOf(shares[part]) < 0);

function shareText({ t, format }: Words, share: number): string {
  const percent = percentOf(share);
  return t('unit.percent', (percent < 0 ? '−' : '') + format.integer(Math.abs(percent)));
}

/** The parts, the largest share first, of equals as the body is gone through. */
export const byShare = (shares: PartShares): readonly BodyPart[] =>
  [...bodyParts].sort((a, b) => shares[b] - shares[a]);

export function paintedBody(words: Words, shares: PartShares): TemplateResult {
  const { t } = words;
  const largest = Math.max(...bodyParts.map((part) => shares[part]));
  const said = byShare(shares).map(
    (part) => `${t(`part.${part}`)} ${shareText(words, shares[part])}`,
  );
  const painted = ([part, path]: (typeof partOutlines)[number]): TemplateResult => {
    const paint = `${paintPercent(shares[part], largest).toFixed(1)}%`;
    return svg`<path class="painted" d=${path} ${styled({ '--paint': paint })} />`;
  };
  return html`<svg
    class="painted-body"
    viewBox="-46 0 92 100"
    role="img"
    aria-label="${t('distance.parts')}: ${said.join(', ')}"
    data-tip=${said.join(', ')}
  >
    ${partOutlines.map(painted)}
    <path class="unpainted" d=${trunkOutline} />
  </svg>`;
}

/** The parts with their shares, the largest first; one below zero makes the clips more alike. */
export function partList(words: Words, shares: PartShares): TemplateResult {
  return html`<table class="part-shares">
    <caption class="spoken">
      ${words.t('distance.parts')}
    </caption>
    <tbody>
      ${byShare(shares).map(
        (part) =>
          html`<tr>
            <th scope="row">${words.t(`part.${part}`)}</th>
            <td>${shareText(words, shares[part])}</td>
          </tr>`,
      )}
    </tbody>
  </table>`;
}
