/** The place of the page in; a set of clips compared out: bar, matrix, evaluation, map and tabs. */
import '../styles/compare.css';
import { computed, signal } from '@preact/signals-core';
import { html, render, type TemplateResult } from 'lit-html';
import type { Context } from '../app/context';
import { follow, mount } from '../common/mount';
import { clipsApart, type Apart } from './apart';
import { mountCompareBar } from './compare-bar';
import { mountEvaluation } from './evaluation-panel';
import { mountMapLegend } from './map-legend';
import { MapView } from './map-view';
import { leastNamedCellPx } from './matrix-axis';
import { noZoom } from './matrix-geometry';
import { matrixHead } from './matrix-head';
import { MatrixPane } from './matrix-pane';
import { createShared, type Shared } from './shared';
import { mountSideTabs } from './side-tabs';
import { mountTopCounts } from './top-counts';

const skeleton = html`<div class="compare-page">
  <div id="compare-bar" class="compare-bar"></div>
  <section class="compare-left">
    <div class="matrix-head"></div>
    <div class="matrix-pane"></div>
    <div class="compare-message"></div>
    <div id="compare-evaluation" class="compare-evaluation"></div>
  </section>
  <section class="compare-map">
    <div class="map-area"></div>
    <div class="map-legend"></div>
  </section>
  <section id="compare-side" class="compare-side"></section>
</div>`;

const part = (place: HTMLElement, selector: string): HTMLElement => {
  const element = place.querySelector<HTMLElement>(selector);
  if (!element) throw new Error(`no ${selector}`);
  return element;
};

export function mountCompare(place: HTMLElement, context: Context): void {
  render(skeleton, place);
  const shared = createShared(place, context);
  const pane = new MatrixPane(part(place, '.matrix-pane'), shared);
  mountMap(place, shared);
  mountCompareBar(part(place, '#compare-bar'), context);
  mountEvaluation(part(place, '#compare-evaluation'), context);
  mountSideTabs(part(place, '#compare-side'), context);
  const middle = document.querySelector<HTMLElement>('#top-middle');
  if (middle) mountTopCounts(middle, context);
  const apart = computed(() => clipsApart(context.store.present.value));
  mount(part(place, '.matrix-head'), () => head(shared, pane, apart.value));
  mountMapLegend(part(place, '.map-legend'), shared);
  mount(part(place, '.compare-message'), () => message(context));
  follow(() => {
    place.setAttribute('aria-label', context.language.words.value.t('compare.page'));
    place.classList.toggle('comparing', context.store.compare.comparing.value !== null);
    place.classList.toggle('compared', shared.scene.value !== null);
  });
}

function mountMap(place: HTMLElement, shared: Shared): void {
  const large = signal(false);
  const page = part(place, '.compare-page');
  const toggle = (): void => {
    large.value = !large.peek();
    page.classList.toggle('map-large', large.value);
  };
  new MapView(part(place, '.map-area'), shared, {
    get value() {
      return large.value;
    },
    toggle,
  });
  place.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape' || event.defaultPrevented || !large.peek()) return;
    event.preventDefault();
    toggle();
  });
}

function head(shared: Shared, pane: MatrixPane, apart: readonly Apart[]): TemplateResult {
  const { store, language, compareActions } = shared.context;
  const { compare } = store;
  const scene = shared.scene.value;
  const geometry = pane.geometry.value;
  const small = geometry !== null && geometry.fit.cell < leastNamedCellPx;
  return matrixHead({
    words: language.words.value,
    legend: scene && {
      words: language.words.value,
      comparison: scene.comparison,
      stops: shared.palette.value.distances,
      distance: distanceOf(shared),
    },
    apart,
    order: compare.order.value,
    zoom:
      geometry && (small || geometry.zoom.cell !== null)
        ? { zoomed: geometry.zoom.cell !== null, by: (factor) => pane.zoomBy(factor) }
        : null,
    onOrder: (order) => compareActions.setOrder(order),
    onZoomAll: () => (pane.zoom.value = noZoom),
  });
}

/** Of the hovered pair, or else of the selected one. */
function distanceOf({ context, facts }: Shared): number | null {
  const { explanation, otherId, hovered } = context.store.compare;
  if (hovered.value && hovered.value.a !== hovered.value.b)
    return facts.value(hovered.value)?.distance ?? null;
  const known = explanation.value;
  const fits = known?.a === context.store.openId.value && known.b === otherId.value;
  return known && fits ? known.distance : null;
}

/** Over the matrix: what is being done, or what is missing. */
function message({ store, language }: Context): TemplateResult {
  const { t } = language.words.value;
  const { comparison, comparing } = store.compare;
  const percent = Math.round(100 * (comparing.value ?? 0));
  if (comparing.value !== null)
    return html`<p role="status">${t('compare.progress', percent)}</p>
      <progress class="bar" max="100" .value=${percent}></progress>`;
  if (comparison.value) return html``;
  const loading = store.loading.value !== null;
  return html`<p>${t(loading ? 'compare.waiting' : 'compare.too-few')}</p>`;
}
