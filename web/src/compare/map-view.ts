/** The shared scene in; the map of its clips out: discs, hulls, a figure for each cluster, zoom and keys. */
import { computed, signal, untracked, type ReadonlySignal } from '@preact/signals-core';
import { html, nothing, render, type TemplateResult } from 'lit-html';
import { iconButton } from '../common/buttons';
import { drawn, styled } from '../common/directives';
import { element } from '../common/element';
import { follow } from '../common/mount';
import { drawFlatFigure, fitFigure } from '../figure/draw-flat-figure';
import { distanceNumber } from './distance-number';
import { clusterAnchors, discRadius, drawHulls, drawMarks } from './map-canvas';
import { MapDiscs } from './map-discs';
import { MapGlide } from './map-glide';
import { MapInput } from './map-input';
import { fitMap, onScreen, placeFigures, type Box, type MapTransform } from './map-layout';
import type { Point } from './hull';
import { PairTip } from './pair-tip';
import type { Scene } from './scene';
import type { Shared } from './shared';

const figurePx = { width: 44, height: 48, padding: 2 };
/** Clusters beyond the largest of so many have no figure. */
const mostFigures = 10;
/** Of more discs, figures keep clear of a sample. */
const mostObstacles = 2000;
const usualMargins: Box = { left: 46, top: 58, right: 46, bottom: 62 };
const clear: Box = { left: 2, top: 34, right: 2, bottom: 34 };
const pillPx = { width: 52, height: 20 };
const shortLinePx = 64;

export interface MapState {
  readonly scene: Scene;
  readonly points: readonly Point[];
  readonly width: number;
  readonly height: number;
}

interface PlacedFigure {
  readonly item: number;
  readonly at: Point;
}

const inside = (width: number, height: number, by: Box): Box => ({
  left: by.left,
  top: by.top,
  right: Math.max(by.left + 1, width - by.right),
  bottom: Math.max(by.top + 1, height - by.bottom),
});

export class MapView {
  readonly transform = signal<MapTransform | null>(null);
  readonly state: ReadonlySignal<MapState | null>;
  private readonly size = signal({ width: 0, height: 0 });
  private readonly layers = {
    hulls: document.createElement('canvas'),
    discs: document.createElement('canvas'),
    marks: document.createElement('canvas'),
  };
  private readonly discs = new MapDiscs();
  private readonly figures = element('div', 'map-figures');
  private readonly pill = element('div', 'map-pill');
  private readonly head = element('div', 'map-head');
  private readonly tip: PairTip;
  private readonly glide: MapGlide;
  private readonly input: MapInput;

  constructor(
    private readonly place: HTMLElement,
    private readonly shared: Shared,
    private readonly large: { readonly value: boolean; readonly toggle: () => void },
  ) {
    this.glide = new MapGlide(shared.scene);
    this.tip = new PairTip(shared);
    this.state = computed(() => this.stateNow());
    this.input = new MapInput(shared, this.state, this.transform, () => this.fitted());
    const layers = Object.values(this.layers);
    for (const layer of layers) layer.className = 'map-canvas';
    for (const part of [...layers, this.figures, this.pill])
      part.setAttribute('aria-hidden', 'true');
    place.append(...layers, this.figures, this.pill, this.input.element);
    place.append(this.head, this.tip.element);
    new ResizeObserver(() => {
      this.size.value = { width: place.clientWidth, height: place.clientHeight };
      this.transform.value = null;
    }).observe(place);
    this.draw();
  }

  private fitted(): MapTransform {
    const { width, height } = this.size.value;
    const map = this.shared.scene.value?.comparison.map ?? new Float64Array();
    return fitMap(map, inside(width, height, usualMargins));
  }

  private stateNow(): MapState | null {
    const { width, height } = this.size.value;
    const scene = this.shared.scene.value;
    if (!scene || width === 0) return null;
    const transform = this.transform.value ?? this.fitted();
    const places = this.glide.places.value;
    const points = Array.from({ length: scene.count }, (_, item) =>
      onScreen(transform, [places[2 * item], places[2 * item + 1]]),
    );
    return { scene, points, width, height };
  }

  private draw(): void {
    const { palette, selected, hovered } = this.shared;
    const { layers } = this;
    follow(() => {
      const state = this.state.value;
      if (state) drawHulls(layers.hulls, { ...state, palette: palette.value });
    });
    follow(() => {
      const state = this.state.value;
      if (state) this.discs.draw(layers.discs, { ...state, palette: palette.value });
    });
    follow(() => {
      const state = this.state.value;
      const marks = { selected: selected.value, hovered: hovered.value };
      if (state) drawMarks(layers.marks, { ...state, ...marks, palette: palette.value });
    });
    const placed = computed(() => (this.glide.gliding.value ? [] : this.placedFigures()));
    follow(() => render(this.drawnFigures(placed.value), this.figures));
    follow(() => this.showPill());
    follow(() => this.input.update());
    follow(() => this.showTip());
    follow(() => render(this.headLine(), this.head));
  }

  private placedFigures(): readonly PlacedFigure[] {
    const state = this.state.value;
    if (!state) return [];
    const { scene, points, width, height } = state;
    const anchors = clusterAnchors(scene, points, mostFigures);
    const step = Math.ceil(points.length / mostObstacles);
    const pill = this.pillPlace();
    const places = placeFigures(anchors, {
      room: inside(width, height, clear),
      ...figurePx,
      points: points.filter((_, k) => k % step === 0),
      radius: discRadius(scene.count) + 1,
      taken: pill ? [pill] : [],
    });
    return anchors.flatMap(({ item }, k) => {
      const at = places[k];
      return at ? [{ item, at }] : [];
    });
  }

  private drawnFigures(placed: readonly PlacedFigure[]): TemplateResult {
    const { width, height, padding } = figurePx;
    const { scene, context } = this.shared;
    const one = ({ item, at: [x, y] }: PlacedFigure): unknown => {
      const id = scene.value?.comparison.clips[item] ?? -1;
      const figure = context.store.clips.value[id]?.thumbnail;
      if (!figure) return nothing;
      const draw = (svg: Element): void =>
        void drawFlatFigure(svg, figure, fitFigure(figure, width, height, padding));
      return html`<svg
        class="map-figure"
        viewBox="0 0 ${width} ${height}"
        ${styled({ left: `${x - width / 2}px`, top: `${y - height / 2}px` })}
        ${drawn(figure, draw)}
      ></svg>`;
    };
    return html`${placed.map(one)}`;
  }

  /** Half way between the two, below them where they stand close. */
  private pillPlace(): Box | null {
    const { a, b } = this.shared.selected.value;
    const points = this.state.value?.points;
    if (!points || a === null || b === null) return null;
    const [from, to] = [points[a], points[b]];
    const close = Math.hypot(to[0] - from[0], to[1] - from[1]) < shortLinePx;
    const x = (from[0] + to[0]) / 2;
    const y = close ? Math.max(from[1], to[1]) + 24 : (from[1] + to[1]) / 2;
    const { width, height } = pillPx;
    return {
      left: x - width / 2,
      right: x + width / 2,
      top: y - height / 2,
      bottom: y + height / 2,
    };
  }

  private showPill(): void {
    const { explanation, otherId } = this.shared.context.store.compare;
    const { openId } = this.shared.context.store;
    const known = explanation.value;
    const box = this.pillPlace();
    const fits = known?.a === openId.value && known.b === otherId.value;
    this.pill.hidden = !box || !fits;
    if (!box || !known) return;
    const { format } = this.shared.context.language.words.value;
    this.pill.textContent = distanceNumber(format, known.distance);
    this.pill.style.left = `${(box.left + box.right) / 2}px`;
    this.pill.style.top = `${(box.top + box.bottom) / 2}px`;
  }

  private showTip(): void {
    const state = this.state.value;
    const hovered = this.shared.hovered.value;
    const over = this.input.focused || this.place.matches(':hover');
    const item = hovered && hovered.a === hovered.b ? hovered.a : null;
    if (!state || item === null || !over) return this.tip.show(null);
    const [x, y] = state.points[item];
    const box = { left: x - 6, top: y - 6, right: x + 6, bottom: y + 6 };
    this.tip.show({ a: item, b: item, box });
  }

  private headLine(): TemplateResult {
    const { t, format } = this.shared.context.language.words.value;
    const scene = this.shared.scene.value;
    const spread = format.integer(Math.round(100 * (scene?.comparison.spread ?? 0)));
    return html`<h2>${t('map.title')}</h2>
      ${
        scene
          ? html`<span class="map-spread" data-tip=${t('map.spread.about')}
              >${t('map.spread', spread)}</span
            >`
          : nothing
      }
      <span class="grow"></span>
      ${
        this.transform.value
          ? iconButton({
              name: 'focus',
              label: t('map.zoom-all'),
              small: true,
              onPress: () => (this.transform.value = null),
            })
          : nothing
      }
      ${iconButton({
        name: this.large.value ? 'minimize' : 'maximize',
        label: t(this.large.value ? 'map.shrink' : 'map.expand'),
        small: true,
        expanded: this.large.value,
        onPress: () => untracked(() => this.large.toggle()),
      })}`;
  }
}
