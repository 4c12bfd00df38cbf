/** The hovered pair and where it is in; a tip with both figures, their distance and its rank out. */
import { html, nothing, render, type TemplateResult } from 'lit-html';
import { untracked } from '@preact/signals-core';
import type { Words } from '../app/i18n/catalogue';
import { drawn } from '../common/directives';
import { element } from '../common/element';
import type { Explanation } from '../engine/comparison-types';
import type { ClipId } from '../engine/types';
import { drawFlatFigure, fitFigure } from '../figure/draw-flat-figure';
import { nameLine } from './clip-words';
import { distanceNumber } from './distance-number';
import type { Arrived } from './map-arrivals';
import type { Box } from './map-layout';
import type { Scene } from './scene';
import type { Shared } from './shared';
import { itemMark } from './item-mark';

const figurePx = { width: 56, height: 62, padding: 4 };
const gapPx = 12;

export interface TipPlace {
  readonly a: number;
  readonly b: number;
  /** What the tip belongs to, in pixels of its parent. */
  readonly box: Box;
}

export class PairTip {
  readonly element = element('div', 'pair-tip');

  constructor(private readonly shared: Shared) {
    this.element.hidden = true;
    this.element.setAttribute('aria-hidden', 'true');
  }

  /** Follows the signals that it reads. */
  show(place: TipPlace | null): void {
    const { scene, facts } = this.shared;
    const shown = scene.value;
    this.element.hidden = !place || !shown;
    if (!place || !shown) return;
    const pair = { a: shown.comparison.clips[place.a], b: shown.comparison.clips[place.b] };
    if (pair.a !== pair.b) untracked(() => facts.ask(pair));
    const known = facts.value(pair);
    render(this.content(shown, place, known), this.element);
    this.stand(place.box);
  }

  /** A clip that is on the map and has not been compared yet. */
  showArrived({ clip, name, label }: Arrived, box: Box): void {
    const { context, scene } = this.shared;
    const { t } = context.language.words.value;
    const line = [scene.value?.labels[label], t('map.arrived')].filter(Boolean).join(' · ');
    this.element.hidden = false;
    const content = html`<div class="tip-figures">${this.figureOf(clip)}</div>
      <div class="tip-names">${itemMark(label)}${nameLine(name)}</div>
      <div class="tip-rank">${line}</div>`;
    render(content, this.element);
    this.stand(box);
  }

  private content(scene: Scene, { a, b }: TipPlace, known: Explanation | null): TemplateResult {
    const words = this.shared.context.language.words.value;
    const named = (item: number): TemplateResult =>
      html`${itemMark(scene.labelOfItem[item])}${nameLine(scene.names[item])}`;
    if (a === b)
      return html`<div class="tip-figures">${this.figure(scene, a)}</div>
        <div class="tip-names">${named(a)}</div>
        ${a in scene.labelOfItem ? labelLine(scene, a, words) : nothing}`;
    return html`<div class="tip-figures">
        ${this.figure(scene, a)}${this.figure(scene, b)}
        <div class="tip-facts">${factsOf(words, scene, known)}</div>
      </div>
      <div class="tip-names">
        ${named(a)}<span class="tip-with">${words.t('matrix.with')}</span>${named(b)}
      </div>`;
  }

  private figure({ comparison }: Scene, item: number): TemplateResult {
    return this.figureOf(comparison.clips[item]);
  }

  private figureOf(clip: ClipId): TemplateResult {
    const figure = this.shared.context.store.clips.value[clip]?.thumbnail ?? null;
    const { width, height, padding } = figurePx;
    const draw = (svg: Element): void => {
      if (figure) drawFlatFigure(svg, figure, fitFigure(figure, width, height, padding));
    };
    return html`<svg
      class="tip-figure"
      width=${width}
      height=${height}
      viewBox="0 0 ${width} ${height}"
      ${drawn(figure, draw)}
    ></svg>`;
  }

  /** Right of and below what it belongs to, or wherever there is room. */
  private stand(box: Box): void {
    const { offsetWidth: width, offsetHeight: height, offsetParent } = this.element;
    const [roomX, roomY] = [offsetParent?.clientWidth ?? 0, offsetParent?.clientHeight ?? 0];
    const right = box.right + gapPx;
    const below = box.bottom + gapPx;
    const left = right + width <= roomX ? right : box.left - gapPx - width;
    const top = below + height <= roomY ? below : box.top - gapPx - height;
    this.element.style.left = `${Math.max(gapPx / 2, Math.min(left, roomX - width - 6))}px`;
    this.element.style.top = `${Math.max(gapPx / 2, Math.min(top, roomY - height - 6))}px`;
  }
}

function labelLine(scene: Scene, item: number, { t }: Words): TemplateResult {
  const label = scene.labels[scene.labelOfItem[item]];
  const cluster = scene.cut ? t('map.cluster', scene.cut.clusterOfItem[item] + 1) : '';
  return html`<div class="tip-rank">${[label, cluster].filter(Boolean).join(' · ')}</div>`;
}

function factsOf(words: Words, { comparison }: Scene, known: Explanation | null): TemplateResult {
  const { t, format } = words;
  const distance = known ? distanceNumber(format, known.distance) : ' ';
  const { pairs } = comparison;
  const rankOf = (rank: number): string =>
    pairs === 1 ? t('matrix.rank.only') : t('matrix.rank', format.ordinal(rank), pairs);
  const rank = known ? rankOf(known.rank) : ' ';
  return html`<strong class="tip-distance">${distance}</strong>
    <span class="tip-rank">${rank}${known?.mirrored ? ` · ${t('matrix.mirrored')}` : nothing}</span>
    <span class="tip-key"><kbd>↵</kbd>${t('matrix.open')}</span>`;
}

/** "07_01 with 09_01, 0.0309, 298th of 741 pairs". */
export function spokenPair(
  words: Words,
  scene: Scene,
  { a, b }: { readonly a: number; readonly b: number },
  known: Explanation | null,
): string {
  const { t, format } = words;
  const [nameA, nameB] = [scene.names[a], scene.names[b]];
  if (a === b) return t('matrix.itself', nameA);
  if (!known) return t('matrix.pair.unranked', nameA, nameB, '…');
  const distance = distanceNumber(format, known.distance);
  const { pairs } = scene.comparison;
  if (pairs === 1) return t('matrix.pair.unranked', nameA, nameB, distance);
  return t('matrix.pair', nameA, nameB, distance, format.ordinal(known.rank), pairs);
}
