/** The scene in; the labels in use under its map out, as many as fit in whole lines, and how many more there are. */
import { signal } from '@preact/signals-core';
import { html, nothing, type TemplateResult } from 'lit-html';
import { labelMark } from '../common/label-mark';
import { mount } from '../common/mount';
import { entriesThatFit } from './legend-fit';
import type { Scene } from './scene';
import type { Shared } from './shared';

const markPx = 17;
const paddingPx = 28;
const fontPx = 12;

const usedIn = (scene: Scene | null): number[] =>
  [...new Set(scene?.labelOfItem)].filter((index) => index >= 0).sort((a, b) => a - b);

function textMeasure(place: Element): (text: string) => number {
  const context = document.createElement('canvas').getContext('2d');
  if (!context) return () => 0;
  context.font = `${fontPx}px ${getComputedStyle(place).fontFamily}`;
  return (text) => Math.ceil(context.measureText(text).width);
}

export function mountMapLegend(place: HTMLElement, { context, scene }: Shared): void {
  const roomPx = signal(0);
  new ResizeObserver(() => {
    // A page that is not shown keeps its room.
    if (place.clientWidth > 0) roomPx.value = place.clientWidth - paddingPx;
  }).observe(place);
  mount(place, (): TemplateResult => {
    const { t } = context.language.words.value;
    const used = usedIn(scene.value);
    const nameOf = (nth: number): string => scene.value?.labels[used[nth]] ?? '';
    const widthOf = textMeasure(place);
    const others = (rest: number): string => t('compare.apart.more', rest);
    const entries = {
      count: used.length,
      widthPx: (nth: number) => markPx + widthOf(nameOf(nth)),
      restPx: (rest: number) => widthOf(others(rest)),
    };
    const shown = entriesThatFit(entries, roomPx.value);
    const entry = (index: number, nth: number): TemplateResult =>
      html`<li title=${nameOf(nth)}>${labelMark(index)}<span>${nameOf(nth)}</span></li>`;
    return html`<ul aria-label=${t('map.legend')}>
      ${used.slice(0, shown).map(entry)}
      ${used.length > shown ? html`<li>${others(used.length - shown)}</li>` : nothing}
    </ul>`;
  });
}
