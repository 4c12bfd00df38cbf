/** The comparison and the selected pair in; the scale of colours with its numbers and a mark out. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { drawn, styled } from '../common/directives';
import type { Words } from '../app/i18n/catalogue';
import type { Comparison } from '../engine/comparison-types';
import { ColourScale } from './colour-scale';

/** Narrower where there is no room. */
const widthPx = 150;
const heightPx = 8;

export interface LegendProps {
  readonly words: Words;
  readonly comparison: Comparison;
  readonly stops: readonly string[];
  /** Of the selected pair; null: none is selected. */
  readonly distance: number | null;
}

function drawScale(svg: Element, stops: readonly string[]): void {
  const scale = new ColourScale(stops, 1);
  for (let x = 0; x < widthPx; x += 1) {
    const rect = document.createElementNS('http://www.w3.org/2000/svg', 'rect');
    const values = { x, width: 1.2, height: heightPx, fill: scale.css((x + 0.5) / widthPx) };
    for (const [name, value] of Object.entries(values)) rect.setAttribute(name, String(value));
    svg.append(rect);
  }
}

/** Digits after the point: three figures where three digits hold them, two of smaller distances. */
export function legendDigits(maximum: number): number {
  const digits = maximum > 0 ? 2 - Math.floor(Math.log10(maximum)) : 0;
  return Math.max(1, Math.min(digits, Math.max(3, digits - 1), 8));
}

export function legend({ words, comparison, stops, distance }: LegendProps): TemplateResult {
  const { t, format } = words;
  const { legendMaximum: end, maximum } = comparison;
  const number = (value: number): string => format.decimal(value, legendDigits(end));
  const part = distance === null || !(end > 0) ? null : Math.min(1, distance / end);
  const range = maximum > end ? 'legend.range.clipped' : 'legend.range';
  return html`<div
    class="legend"
    role="img"
    aria-label=${t('legend.label', number(end), number(maximum))}
  >
    <span>${t('legend.alike')}</span>
    <span class="legend-scale">
      <svg
        preserveAspectRatio="none"
        shape-rendering="crispEdges"
        height=${heightPx}
        viewBox="0 0 ${widthPx} ${heightPx}"
        ${drawn(stops.join(), (svg) => drawScale(svg, stops))}
      ></svg>
      ${
        part === null
          ? nothing
          : html`<i class="legend-mark" ${styled({ left: `${part * 100}%` })}></i>`
      }
    </span>
    <span>${t('legend.different')}</span>
    <span class="legend-range">${t(range, number(end))}</span>
  </div>`;
}
