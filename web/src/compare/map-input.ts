/** Pointer and keys over the map in; the hovered and the chosen clip, zoom and pan out. */
import type { ReadonlySignal, Signal } from '@preact/signals-core';
import { element } from '../common/element';
import { nearestTowards, pointAt, zoomed, type Direction, type MapTransform } from './map-layout';
import type { MapState } from './map-view';
import { RovingCell } from './roving-cell';
import { clusterNumber, type Scene } from './scene';
import { choose, hover, openPair, type Shared } from './shared';

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
  private scene: Scene | null = null;
  private item = 0;
  private drag: { x: number; y: number; transform: MapTransform; moved: boolean } | null = null;

  constructor(
    private readonly shared: Shared,
    private readonly state: ReadonlySignal<MapState | null>,
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
    const state = this.state.value;
    const { t } = this.shared.context.language.words.value;
    this.element.setAttribute('aria-label', t('map.label'));
    this.element.setAttribute('aria-description', t('map.help'));
    if (!state || state.scene.count === 0) return;
    const { selected } = this.shared;
    const another = this.scene?.comparison !== state.scene.comparison;
    this.scene = state.scene;
    if (!this.focused) this.item = selected.value.a ?? (another ? 0 : this.item);
    this.item = Math.min(this.item, state.scene.count - 1);
    this.roving.stand(this.placeOf(state));
    this.roving.say(this.words(state.scene));
  }

  private placeOf({ points }: MapState) {
    const [x, y] = points[this.item];
    return { left: x - cellPx / 2, top: y - cellPx / 2, width: cellPx, height: cellPx };
  }

  private words(scene: Scene): string {
    const { t } = this.shared.context.language.words.value;
    const label = scene.labels[scene.labelOfItem[this.item]] ?? t('names.no-label');
    return t('map.point', scene.names[this.item], label, clusterNumber(scene, this.item));
  }

  private move(direction: Direction): void {
    const state = this.state.peek();
    if (!state) return;
    const next = nearestTowards(state.points, this.item, direction);
    if (next < 0) return;
    this.item = next;
    this.roving.renew(this.words(state.scene), this.placeOf(state));
    hover(this.shared, { a: next, b: next });
  }

  private readonly onKey = (event: KeyboardEvent): void => {
    const state = this.state.peek();
    if (!state || event.ctrlKey || event.metaKey || event.altKey) return;
    const { key } = event;
    const [x, y] = state.points[this.item] ?? [0, 0];
    if (key in directions) this.move(directions[key]);
    else if (key === 'Enter' || key === ' ')
      choose(this.shared, this.item, event.shiftKey ? 'b' : 'a');
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

  private itemAt(event: MouseEvent): number {
    const box = this.element.getBoundingClientRect();
    const points = this.state.peek()?.points ?? [];
    return pointAt(points, event.clientX - box.left, event.clientY - box.top, reachPx);
  }

  private listen(): void {
    const map = this.element;
    map.addEventListener('keydown', this.onKey);
    map.addEventListener('focusin', () => hover(this.shared, { a: this.item, b: this.item }));
    map.addEventListener('focusout', () => hover(this.shared, null));
    map.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      const transform = this.transform.peek() ?? this.fitted();
      this.drag = { x: event.clientX, y: event.clientY, transform, moved: false };
      map.setPointerCapture(event.pointerId);
    });
    map.addEventListener('pointermove', this.onMove);
    map.addEventListener('pointerleave', () => !this.focused && hover(this.shared, null));
    map.addEventListener('click', (event) => this.onClick(event));
    map.addEventListener('dblclick', (event) => {
      const { a, b } = this.shared.selected.peek();
      if (this.itemAt(event) >= 0 && a !== null && b !== null) openPair(this.shared, a, b);
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
    const item = this.itemAt(event);
    this.element.classList.toggle('over', item >= 0);
    hover(this.shared, item < 0 ? null : { a: item, b: item });
  };

  private onClick(event: MouseEvent): void {
    const dragged = this.drag?.moved;
    this.drag = null;
    const item = this.itemAt(event);
    if (dragged || item < 0) return;
    choose(this.shared, item, event.shiftKey || event.ctrlKey || event.metaKey ? 'b' : 'a');
  }

  private readonly onWheel = (event: WheelEvent): void => {
    if (!this.state.peek()) return;
    event.preventDefault();
    const box = this.element.getBoundingClientRect();
    const factor = Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.002));
    this.zoomAt(factor, event.clientX - box.left, event.clientY - box.top);
  };
}
