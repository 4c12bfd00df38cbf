/** Pointer and keys over the map in; the hovered and the chosen clip, zoom and pan out. */
import type { ReadonlySignal, Signal } from '@preact/signals-core';
import { element } from '../common/element';
import { nearestTowards, pointAt, zoomed, type Direction, type MapTransform } from './map-layout';
import type { ClipId } from '../engine/types';
import { clipAt, labelAt, nameAt, spotOf, type Spots } from './map-spots';
import { RovingCell } from './roving-cell';
import { clusterNumber } from './scene';
import { chooseClip, hoverClips, openPair, type Shared } from './shared';
import { pageScrolls, zoomFactor } from './wheel-zoom';

const reachPx = 14;
const dragPx = 4;
const zoomStep = 1.5;
const cellPx = 22;
const directions: Readonly<Record<string, Direction>> = {
  ArrowLeft: 'left',
  ArrowRight: 'right',
  ArrowUp: 'up',
  ArrowDown: 'down',
};

export class MapInput {
  readonly element = element('div', 'map-input');
  private readonly roving: RovingCell;
  private clip: ClipId | null = null;
  private spot = 0;
  private drag: { x: number; y: number; transform: MapTransform; moved: boolean } | null = null;

  constructor(
    private readonly shared: Shared,
    private readonly spots: ReadonlySignal<Spots | null>,
    private readonly transform: Signal<MapTransform | null>,
    private readonly fitted: () => MapTransform,
  ) {
    this.element.setAttribute('role', 'group');
    this.roving = new RovingCell(this.element, () => {
      const point = element('div', 'map-point');
      point.setAttribute('role', 'button');
      point.tabIndex = 0;
      return point;
    });
    this.listen();
  }

  get focused(): boolean {
    return this.roving.focused;
  }

  update(): void {
    const spots = this.spots.value;
    const { t } = this.shared.context.language.words.value;
    this.element.setAttribute('aria-label', t('map.label'));
    this.element.setAttribute('aria-description', t('map.help'));
    this.element.classList.toggle('pans', this.transform.value !== null);
    if (!spots || spots.points.length === 0) return;
    const { openId } = this.shared.context.store;
    const open = spotOf(spots, openId.value);
    this.standAt(spots, (this.focused ? null : open) ?? spotOf(spots, this.clip) ?? 0);
    this.roving.stand(this.placeOf(spots));
    this.roving.say(this.words(spots));
  }

  private standAt(spots: Spots, spot: number): void {
    this.spot = spot;
    this.clip = clipAt(spots, spot) ?? null;
  }

  private placeOf({ points }: Spots) {
    const [x, y] = points[this.spot];
    return { left: x - cellPx / 2, top: y - cellPx / 2, width: cellPx, height: cellPx };
  }

  private words(spots: Spots): string {
    const { t } = this.shared.context.language.words.value;
    const { spot } = this;
    const label = spots.scene.labels[labelAt(spots, spot)] ?? t('names.no-label');
    const name = nameAt(spots, spot);
    if (spot >= spots.scene.count) return t('map.point.arrived', name, label);
    return t('map.point', name, label, clusterNumber(spots.scene, spot));
  }

  private hoverSpot(spots: Spots, spot: number): void {
    const clip = clipAt(spots, spot);
    hoverClips(this.shared, clip === undefined ? null : { a: clip, b: clip });
  }

  private chooseSpot(spots: Spots, spot: number, as: 'a' | 'b'): void {
    const clip = clipAt(spots, spot);
    if (clip !== undefined) chooseClip(this.shared, clip, as);
  }

  private move(direction: Direction): void {
    const spots = this.spots.peek();
    if (!spots) return;
    const next = nearestTowards(spots.points, this.spot, direction);
    if (next < 0) return;
    this.standAt(spots, next);
    this.roving.renew(this.words(spots), this.placeOf(spots));
    this.hoverSpot(spots, next);
  }

  private readonly onKey = (event: KeyboardEvent): void => {
    const spots = this.spots.peek();
    if (!spots || event.ctrlKey || event.metaKey || event.altKey) return;
    const { key } = event;
    const [x, y] = spots.points[this.spot] ?? [0, 0];
    if (key in directions) this.move(directions[key]);
    else if (key === 'Enter' || key === ' ')
      this.chooseSpot(spots, this.spot, event.shiftKey ? 'b' : 'a');
    else if (key === '+' || key === '=') this.zoomAt(zoomStep, x, y);
    else if (key === '-') this.zoomAt(1 / zoomStep, x, y);
    else if (key === '0') this.transform.value = null;
    else return;
    event.preventDefault();
  };

  /** Never smaller than the whole. */
  private zoomAt(factor: number, x: number, y: number): void {
    const whole = this.fitted();
    const next = zoomed(this.transform.peek() ?? whole, factor, x, y);
    this.transform.value = next.scale <= whole.scale * 1.001 ? null : next;
  }

  private spotAt(event: MouseEvent): number {
    const box = this.element.getBoundingClientRect();
    const points = this.spots.peek()?.points ?? [];
    return pointAt(points, event.clientX - box.left, event.clientY - box.top, reachPx);
  }

  private listen(): void {
    const map = this.element;
    map.addEventListener('keydown', this.onKey);
    map.addEventListener('focusin', () => {
      const spots = this.spots.peek();
      if (spots) this.hoverSpot(spots, this.spot);
    });
    map.addEventListener('focusout', () => hoverClips(this.shared, null));
    map.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      const transform = this.transform.peek() ?? this.fitted();
      this.drag = { x: event.clientX, y: event.clientY, transform, moved: false };
      map.setPointerCapture(event.pointerId);
    });
    map.addEventListener('pointermove', this.onMove);
    map.addEventListener('pointerleave', () => !this.focused && hoverClips(this.shared, null));
    map.addEventListener('click', (event) => this.onClick(event));
    map.addEventListener('dblclick', (event) => {
      const { a, b } = this.shared.selected.peek();
      if (this.spotAt(event) >= 0 && a !== null && b !== null) openPair(this.shared, a, b);
    });
    map.addEventListener('wheel', this.onWheel, { passive: false });
  }

  private readonly onMove = (event: PointerEvent): void => {
    const { drag } = this;
    if (drag && this.element.hasPointerCapture(event.pointerId)) {
      const [dx, dy] = [event.clientX - drag.x, event.clientY - drag.y];
      drag.moved ||= Math.hypot(dx, dy) > dragPx;
      // The whole map has nowhere to go.
      if (drag.moved && this.transform.peek())
        this.transform.value = {
          ...drag.transform,
          x: drag.transform.x + dx,
          y: drag.transform.y + dy,
        };
      if (drag.moved) return;
    }
    const spots = this.spots.peek();
    const spot = this.spotAt(event);
    this.element.classList.toggle('over', spot >= 0);
    if (spots && spot >= 0) this.hoverSpot(spots, spot);
    else hoverClips(this.shared, null);
  };

  private onClick(event: MouseEvent): void {
    const dragged = this.drag?.moved;
    this.drag = null;
    const spots = this.spots.peek();
    const spot = this.spotAt(event);
    if (dragged || !spots || spot < 0) return;
    const second = event.shiftKey || event.ctrlKey || event.metaKey;
    this.chooseSpot(spots, spot, second ? 'b' : 'a');
  }

  private readonly onWheel = (event: WheelEvent): void => {
    const factor = zoomFactor(event, pageScrolls(this.element));
    if (!this.spots.peek() || factor === null) return;
    event.preventDefault();
    const box = this.element.getBoundingClientRect();
    this.zoomAt(factor, event.clientX - box.left, event.clientY - box.top);
  };
}
