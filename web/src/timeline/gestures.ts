/**
 * What pointers and wheels do in the rows: press and drag to scrub, drag on the ruler to make a loop,
 * turn the wheel to zoom and pan, two fingers to do both.
 */
import type { LoopRange } from '../player/clock';
import type { Axis, AxisSpan } from './axis';
import { Touches } from './touches';
import { turnOf } from './wheel';
import { panned, zoomed } from './zoom';

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

interface Place {
  readonly x: number;
  readonly y: number;
}

interface Press extends Place {
  readonly kind: 'scrub' | 'range';
  readonly frame: number;
  /** Its end without a drag goes to the frame. A finger may be the first of two, or turn the page. */
  readonly late: boolean;
  dragged: boolean;
}

export class Gestures {
  private press: Press | null = null;
  private readonly touches = new Touches();

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
    if (event.pointerType === 'touch') this.touches.put(event.pointerId, place.x);
    if (this.touches.count > 1) {
      this.press = null;
      return;
    }
    const onFlag = event.target instanceof Element && event.target.closest('.playhead') !== null;
    const kind = this.ground.isRuler(place.y) && !onFlag ? 'range' : 'scrub';
    const frame = this.ground.momentAt(place.x, place.y, event.target) ?? axis.frameAt(place.x);
    const late = kind === 'range' || (event.pointerType === 'touch' && !onFlag);
    this.press = { ...place, kind, frame, late, dragged: false };
    if (!late && !onFlag) this.events.onSeek(frame);
  }

  private move(event: PointerEvent): void {
    const place = this.placeOf(event);
    if (this.touches.count > 1) return this.pinch(event.pointerId, place);
    if (this.touches.has(event.pointerId)) this.touches.put(event.pointerId, place.x);
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
    this.touches.lift(event.pointerId);
    const { press } = this;
    this.press = null;
    if (press?.late && !press.dragged && event.type === 'lostpointercapture')
      this.events.onSeek(press.frame);
  }

  private hover(event: PointerEvent, { x, y }: Place): void {
    const moment = this.ground.momentAt(x, y, event.target);
    this.area.classList.toggle('pointing', moment !== null);
    this.events.onHover(moment ?? this.ground.frameAt(x, event.target));
  }

  /** Both fingers keep the frames that they touch. */
  private pinch(id: number, { x }: Place): void {
    const axis = this.ground.axis();
    const spread = this.touches.move(id, x);
    if (!spread) return;
    const about = axis.placeAt(spread.about);
    this.events.onZoom(zoomed(axis.span, axis.lastFrame, spread.factor, about));
  }

  private turn(event: WheelEvent): void {
    const axis = this.ground.axis();
    const turn = turnOf(event);
    if (turn === null) return;
    event.preventDefault();
    if ('pan' in turn)
      return this.events.onZoom(panned(axis.span, axis.lastFrame, turn.pan / axis.scale));
    const about = this.ground.frameAt(this.placeOf(event).x, event.target);
    this.events.onZoom(zoomed(axis.span, axis.lastFrame, turn.factor, about));
  }
}
