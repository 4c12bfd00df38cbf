/**
 * What pointers and wheels do in the rows: press and drag to scrub, drag on the ruler to make a loop,
 * turn the wheel to zoom and pan, two fingers to do both.
 */
import type { LoopRange } from '../player/clock';
import type { Axis, AxisSpan } from './axis';
import { fitted, panned, zoomed } from './zoom';

export interface GestureEvents {
  onSeek(frame: number): void;
  onHover(frame: number | null): void;
  onZoom(span: AxisSpan | null): void;
  onLoop(range: LoopRange): void;
}

/** What the gestures must know of the timeline, at the moment they happen. */
export interface GestureGround {
  axis(): Axis;
  /** The moment at a pixel of what lies under the pointer: the rows, or the overview of the whole clip. */
  frameAt(x: number, target: EventTarget | null): number;
  isRuler(y: number): boolean;
  /** The moment of what lies under the pointer; null where it is the axis alone. */
  momentAt(x: number, y: number, target: EventTarget | null): number | null;
}

/** A press that moves less than this is no drag, in pixels. */
const DRAG_START = 4;
const ZOOM_PER_PIXEL = 0.003;
const LINE_HEIGHT = 16;
/** A wheel that says pages. */
const PAGE_HEIGHT = 400;

interface Place {
  readonly x: number;
  readonly y: number;
}

interface Press extends Place {
  readonly kind: 'scrub' | 'range';
  readonly frame: number;
  dragged: boolean;
}

export class Gestures {
  private press: Press | null = null;
  private readonly touches = new Map<number, Place>();

  constructor(
    private readonly area: HTMLElement,
    private readonly ground: GestureGround,
    private readonly events: GestureEvents,
  ) {
    area.addEventListener('pointerdown', (event) => this.down(event));
    area.addEventListener('pointermove', (event) => this.move(event));
    for (const type of ['lostpointercapture', 'pointercancel'] as const)
      area.addEventListener(type, (event) => this.up(event));
    area.addEventListener('pointerleave', () => this.events.onHover(null));
    area.addEventListener('wheel', (event) => this.turn(event), { passive: false });
  }

  private placeOf({ clientX, clientY }: MouseEvent): Place {
    const { left, top } = this.area.getBoundingClientRect();
    return { x: clientX - left, y: clientY - top };
  }

  private down(event: PointerEvent): void {
    if (event.button !== 0 || event.target instanceof HTMLButtonElement) return;
    const place = this.placeOf(event);
    const axis = this.ground.axis();
    this.area.setPointerCapture(event.pointerId);
    this.events.onHover(null);
    if (event.pointerType === 'touch') this.touches.set(event.pointerId, place);
    if (this.touches.size > 1) {
      this.press = null;
      return;
    }
    const onFlag = event.target instanceof Element && event.target.closest('.playhead') !== null;
    const kind = this.ground.isRuler(place.y) && !onFlag ? 'range' : 'scrub';
    const frame = this.ground.momentAt(place.x, place.y, event.target) ?? axis.frameAt(place.x);
    this.press = { ...place, kind, frame, dragged: false };
    if (kind === 'scrub' && !onFlag) this.events.onSeek(frame);
  }

  private move(event: PointerEvent): void {
    const place = this.placeOf(event);
    if (this.touches.size > 1) return this.pinch(event.pointerId, place);
    if (this.touches.has(event.pointerId)) this.touches.set(event.pointerId, place);
    if (this.press === null) return this.hover(event, place);
    this.press.dragged ||= Math.abs(place.x - this.press.x) >= DRAG_START;
    if (this.press.dragged) this.drag(this.press, place.x);
  }

  private drag(press: Press, x: number): void {
    const frame = this.ground.axis().frameAt(x);
    if (press.kind === 'scrub') this.events.onSeek(frame);
    else if (frame !== press.frame)
      this.events.onLoop({ a: Math.min(frame, press.frame), b: Math.max(frame, press.frame) });
  }

  private up(event: PointerEvent): void {
    this.touches.delete(event.pointerId);
    const { press } = this;
    this.press = null;
    if (press?.kind === 'range' && !press.dragged && event.type === 'lostpointercapture')
      this.events.onSeek(press.frame);
  }

  private hover(event: PointerEvent, { x, y }: Place): void {
    const moment = this.ground.momentAt(x, y, event.target);
    this.area.classList.toggle('pointing', moment !== null);
    this.events.onHover(moment ?? this.ground.frameAt(x, event.target));
  }

  /** Both fingers keep the frames that they touch. */
  private pinch(id: number, place: Place): void {
    const other = [...this.touches].find(([touch]) => touch !== id)?.[1];
    const before = this.touches.get(id);
    if (other === undefined || before === undefined) return;
    this.touches.set(id, place);
    const axis = this.ground.axis();
    const [still, moved] = [axis.placeAt(other.x), axis.placeAt(before.x)];
    if (Math.abs(place.x - other.x) < 1 || still === moved) return;
    const scale = (moved - still) / (place.x - other.x);
    if (scale <= 0) return;
    const first = still - (other.x - axis.x(axis.span.first)) * scale;
    const length = (axis.x(axis.span.last) - axis.x(axis.span.first)) * scale;
    this.events.onZoom(fitted({ first, last: first + length }, axis.lastFrame));
  }

  /** With Ctrl (which a pinch on a touchpad sets too) or Meta it zooms, sideways or with Shift it pans. */
  private turn(event: WheelEvent): void {
    const axis = this.ground.axis();
    const unit = [1, LINE_HEIGHT, PAGE_HEIGHT][event.deltaMode] ?? 1;
    if (event.ctrlKey || event.metaKey) {
      event.preventDefault();
      const factor = Math.exp(-event.deltaY * unit * ZOOM_PER_PIXEL);
      const about = this.ground.frameAt(this.placeOf(event).x, event.target);
      this.events.onZoom(zoomed(axis.span, axis.lastFrame, factor, about));
      return;
    }
    const sideways = event.shiftKey && event.deltaX === 0 ? event.deltaY : event.deltaX;
    if (!event.shiftKey && Math.abs(sideways) <= Math.abs(event.deltaY)) return;
    event.preventDefault();
    this.events.onZoom(panned(axis.span, axis.lastFrame, (sideways * unit) / axis.scale));
  }
}
