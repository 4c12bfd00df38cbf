/** The 12 shares of a distance in; a table of bars out: mean over time and deviation of each component. */
import '../styles/distance.css';
import { html, svg, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { components, type Component } from './why-words';
import { sigma } from './why-sentence';

export const barWidth = 76;
const barHeight = 9;
/** A share that is there at all shows. */
const leastShown = 0.002;
const leastWidth = 1.5;
/** From here on a share stands out. */
const outstanding = 0.3;

export function barLength(share: number): number {
  const length = Math.max(0, Math.min(1, share)) * barWidth;
  return share > leastShown ? Math.max(leastWidth, length) : length;
}

function cell({ t, format }: Words, component: Component, share: number): TemplateResult {
  const bar = svg`<rect class="share-track" width=${barWidth} height=${barHeight} rx="2" />
    <rect class="share-bar" width=${barLength(share)} height=${barHeight} rx="2" />`;
  return html`<td class="share ${share > outstanding ? 'outstanding' : ''}">
    <span
      ><span class="share-symbol" aria-hidden="true">${sigma(component)}</span
      ><svg viewBox="0 0 ${barWidth} ${barHeight}" aria-hidden="true">${bar}</svg
      ><span class="share-value">${t('unit.percent', format.integer(share * 100))}</span></span
    >
  </td>`;
}

/** `shares`: six of the means, six of the deviations. */
export function componentBars(words: Words, shares: ArrayLike<number>): TemplateResult {
  const { t } = words;
  const row = (component: Component, index: number): TemplateResult =>
    html`<tr>
      <th scope="row" title=${t(`distance.component.${component}`)}>
        ${sigma(component)}<span class="spoken">${t(`distance.component.${component}`)}</span>
      </th>
      ${cell(words, component, shares[index] ?? 0)}
      ${cell(words, component, shares[index + components.length] ?? 0)}
    </tr>`;
  return html`<table class="component-bars">
    <caption class="spoken">
      ${t('distance.shares')}
    </caption>
    <thead>
      <tr>
        <td></td>
        <th scope="col">${t('distance.mean')}</th>
        <th scope="col">${t('distance.deviation')}</th>
      </tr>
    </thead>
    <tbody>
      ${components.map(row)}
    </tbody>
  </table>`;
}
