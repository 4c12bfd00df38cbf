/** The shared scene in; the map of its clips out: discs, hulls, a figure for each cluster, zoom and keys. */
import { computed, signal, untracked, type ReadonlySignal } from '@preact/signals-core';
import { html, nothing, render, type TemplateResult } from 'lit-html';
import { iconButton } from '../common/buttons';
import { element } from '../common/element';
import { follow } from '../common/mount';
import type { ClipId } from '../engine/types';
import { distanceNumber } from './distance-number';
import { drawHulls, drawMarks } from './map-canvas';
import { MapDiscs } from './map-discs';
import { figuresBeside, mapFigure, type PlacedFigure } from './map-figures';
import { MapGlide } from './map-glide';
import { MapInput } from './map-input';
import { onScreen, type Box, type MapRoom, type MapTransform } from './map-layout';
import { spotOf, type Spots } from './map-spots';
import type { Point } from './hull';
import type { Size } from './matrix-geometry';
import { PairTip } from './pair-tip';
import type { Scene } from './scene';
import type { ItemPair, Shared } from './shared';

const usualMargins: Box = { left: 46, top: 58, right: 46, bottom: 62 };
const clear: Box = { left: 2, top: 34, right: 2, bottom: 34 };
const pillPx = { width: 52, height: 20 };
const shortLinePx = 64;

interface MapState extends Size {
  readonly scene: Scene;
  readonly points: readonly Point[];
}

const inside = ({ width, height }: Size, by: Box): Box => ({
  left: by.left,
  top: by.top,
  right: Math.max(by.left + 1, width - by.right),
  bottom: Math.max(by.top + 1, height - by.bottom),
});

function roomOf(size: Size): MapRoom | null {
  if (size.width === 0) return null;
  return { usual: inside(size, usualMargins), outer: inside(size, clear) };
}

export class MapView {
  readonly transform = signal<MapTransform | null>(null);
  /** What has been compared. */
  private readonly state: ReadonlySignal<MapState | null>;
  /** That and what has arrived since. */
  private readonly spots: ReadonlySignal<Spots | null>;
  private readonly size = signal({ width: 0, height: 0 });
  private readonly room = computed(() => roomOf(this.size.value));
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
    this.glide = new MapGlide(shared.scene, shared.arrived, this.room);
    this.tip = new PairTip(shared);
    this.state = computed(() => this.stateNow());
    this.spots = computed(() => this.spotsNow());
    this.input = new MapInput(shared, this.spots, this.transform, () => this.glide.fit.peek());
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

  private readonly pointsOf = (places: Float64Array): readonly Point[] => {
    const transform = this.transform.value ?? this.glide.fit.value;
    return Array.from({ length: places.length / 2 }, (_, k) =>
      onScreen(transform, [places[2 * k], places[2 * k + 1]]),
    );
  };

  private stateNow(): MapState | null {
    const { width, height } = this.size.value;
    const scene = this.shared.scene.value;
    const places = this.glide.places.value;
    if (!scene || width === 0 || places.length !== 2 * scene.count) return null;
    return { scene, points: this.pointsOf(places), width, height };
  }

  private spotsNow(): Spots | null {
    const state = this.state.value;
    const arrived = this.shared.arrived.value;
    const places = this.glide.arrivedPlaces.value;
    if (!state) return null;
    const { scene, points } = state;
    if (places.length !== 2 * arrived.length) return { scene, points, arrived: [] };
    return { scene, points: points.concat(this.pointsOf(places)), arrived };
  }

  private draw(): void {
    const { palette } = this.shared;
    const { layers, size } = this;
    follow(() => {
      const state = this.state.value;
      if (state) drawHulls(layers.hulls, { ...state, palette: palette.value });
    });
    follow(() => {
      const spots = this.spots.value;
      if (spots) this.discs.draw(layers.discs, { spots, ...size.value, palette: palette.value });
    });
    follow(() => {
      const spots = this.spots.value;
      if (!spots) return;
      const marks = this.markedSpots(spots);
      drawMarks(layers.marks, { spots, ...marks, ...size.value, palette: palette.value });
    });
    // Not computed: finding room for figures takes too long for what changes the scene, and has a frame.
    const placed = signal<readonly PlacedFigure[]>([]);
    follow(() => void (placed.value = this.glide.gliding.value ? [] : this.placedFigures()));
    follow(() =>
      render(
        placed.value.map((one) => this.figureOf(one)),
        this.figures,
      ),
    );
    follow(() => this.showPill());
    follow(() => this.input.update());
    follow(() => this.showTip());
    follow(() => render(this.headLine(), this.head));
  }

  private markedSpots(spots: Spots): { selected: ItemPair; hovered: ItemPair | null } {
    const { store } = this.shared.context;
    const hovered = store.compare.hovered.value;
    const pair = (a: ClipId | null, b: ClipId | null): ItemPair => ({
      a: spotOf(spots, a),
      b: spotOf(spots, b),
    });
    return {
      selected: pair(store.openId.value, store.compare.otherId.value),
      hovered: hovered && pair(hovered.a, hovered.b),
    };
  }

  private placedFigures(): readonly PlacedFigure[] {
    const state = this.state.value;
    if (!state) return [];
    const pill = this.pillPlace();
    return figuresBeside(state, inside(state, clear), pill ? [pill] : []);
  }

  private figureOf(placed: PlacedFigure): TemplateResult | typeof nothing {
    const { scene, context } = this.shared;
    const id = scene.value?.comparison.clips[placed.item] ?? -1;
    const figure = context.store.clips.value[id]?.thumbnail;
    return figure ? mapFigure(figure, placed.at) : nothing;
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
    const spots = this.spots.value;
    const hovered = this.shared.context.store.compare.hovered.value;
    const over = this.input.focused || this.place.matches(':hover');
    const clip = hovered && hovered.a === hovered.b ? hovered.a : null;
    const spot = spots && spotOf(spots, clip);
    if (!spots || spot === null || !over) return this.tip.show(null);
    const [x, y] = spots.points[spot];
    const box = { left: x - 6, top: y - 6, right: x + 6, bottom: y + 6 };
    if (spot < spots.scene.count) this.tip.show({ a: spot, b: spot, box });
    else this.tip.showArrived(spots.arrived[spot - spots.scene.count], box);
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
