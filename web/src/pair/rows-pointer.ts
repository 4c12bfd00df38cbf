/**
 * Pointers and wheel over the rows in; the time they lead to, the moment they show, the loop and the zoom out.
 * A drag scrubs; on the ruler of a clip it makes a loop.
 */
import { Touches } from '../timeline/touches';
import { turnOf } from '../timeline/wheel';
import { isInLoop, setLoop } from './loop-frames';
import { isOnFlag } from './pair-playhead';
import type { PairState } from './pair-state';
import { clipAt, rulerAt } from './rows-layout';
import type { TwoSignal } from './two';

interface Place {
  readonly x: number;
  readonly y: number;
}

/** A press that is held. */
interface Hold {
  /** Whose time a drag moves: it stays the one where the drag began. */
  readonly clip: 0 | 1;
  readonly x: number;
  readonly frame: number;
  readonly kind: 'scrub' | 'loop';
  /** Its end without a drag goes to the frame. A finger may be the first of two, or turn the page. */
  readonly late: boolean;
  dragged: boolean;
}

/** A late press that moves less than this is no drag, in pixels. */
const DRAG_START = 4;

export function listenToRows(area: HTMLElement, state: PairState, two: TwoSignal): void {
  new RowsPointer(area, state, two);
}

class RowsPointer {
  private readonly touches = new Touches();
  private hold: Hold | null = null;

  constructor(
    private readonly area: HTMLElement,
    private readonly state: PairState,
    private readonly two: TwoSignal,
  ) {
    area.addEventListener('pointerdown', (event) => this.press(event));
    area.addEventListener('pointermove', (event) => this.move(event));
    for (const type of ['lostpointercapture', 'pointercancel'] as const)
      area.addEventListener(type, (event) => this.end(event));
    area.addEventListener('pointerleave', () => {
      state.hovered.value = null;
    });
    area.addEventListener('dblclick', (event) => this.clear(event));
    area.addEventListener('wheel', (event) => this.turn(event), { passive: false });
  }

  private placeOf({ clientX, clientY }: MouseEvent): Place {
    const { left, top } = this.area.getBoundingClientRect();
    return { x: clientX - left, y: clientY - top };
  }

  private momentAt({ x, y }: Place): { readonly clip: 0 | 1; readonly frame: number } | null {
    const clip = clipAt(y);
    const axis = this.two.peek()?.axes[clip];
    return axis ? { clip, frame: axis.frameAt(x) } : null;
  }

  private press(event: PointerEvent): void {
    const place = this.placeOf(event);
    const moment = this.momentAt(place);
    if (event.button !== 0 || isOnButton(event) || !moment) return;
    const { clip, frame } = moment;
    this.area.setPointerCapture(event.pointerId);
    this.state.hovered.value = null;
    const byTouch = event.pointerType === 'touch';
    if (byTouch) this.touches.put(event.pointerId, place.x);
    const onFlag = this.isFlag(place);
    const kind = rulerAt(place.y) === null || onFlag ? 'scrub' : 'loop';
    const late = kind === 'loop' || (byTouch && !onFlag);
    const several = this.touches.count > 1;
    this.hold = several ? null : { clip, x: place.x, frame, kind, late, dragged: false };
    if (!late) this.drag(place.x);
  }

  private isFlag({ x, y }: Place): boolean {
    const shown = this.two.peek();
    if (!shown) return false;
    const { frames } = this.state.moment.peek();
    const [a, b] = shown.axes;
    return isOnFlag(x, y, [a.x(frames[0]), b.x(frames[1])]);
  }

  private move(event: PointerEvent): void {
    const place = this.placeOf(event);
    if (this.touches.count > 1) return this.pinch(event.pointerId, place);
    if (this.touches.has(event.pointerId)) this.touches.put(event.pointerId, place.x);
    if (this.hold) this.drag(place.x);
    else if (!isOnButton(event)) this.state.hovered.value = this.momentAt(place);
  }

  private drag(x: number): void {
    const { hold } = this;
    const axis = hold && this.two.peek()?.axes[hold.clip];
    if (!hold || !axis) return;
    const { clip, frame: from, kind, late } = hold;
    const frame = axis.frameAt(x);
    hold.dragged ||= Math.abs(x - hold.x) >= DRAG_START;
    if (late && !hold.dragged) return;
    if (kind === 'scrub') this.state.clock.seek(clip, frame);
    else if (frame !== from) {
      const range = { a: Math.min(frame, from), b: Math.max(frame, from) };
      setLoop(this.state, this.two.peek(), clip, range);
    }
  }

  private end({ pointerId, type }: PointerEvent): void {
    this.touches.lift(pointerId);
    const { hold } = this;
    this.hold = null;
    if (type === 'lostpointercapture' && hold?.late && !hold.dragged)
      this.state.clock.seek(hold.clip, hold.frame);
  }

  private clear(event: MouseEvent): void {
    const shown = this.two.peek();
    if (!shown || isOnButton(event)) return;
    const { x, y } = this.placeOf(event);
    const clip = clipAt(y);
    if (isInLoop(this.state, shown, clip, shown.axes[clip].placeAt(x)))
      this.state.clock.setLoop(null);
  }

  /** What a finger that stays touches keeps its place. */
  private pinch(id: number, { x, y }: Place): void {
    const spread = this.touches.move(id, x);
    const moment = spread && this.momentAt({ x: spread.about, y });
    if (moment) this.state.rows.zoomAbout(moment.clip, moment.frame, spread.factor);
  }

  private turn(event: WheelEvent): void {
    const turned = turnOf(event);
    const shown = this.two.peek();
    const moment = this.momentAt(this.placeOf(event));
    if (!turned || !moment || !shown) return;
    event.preventDefault();
    const { clip, frame } = moment;
    const pixelsPerSecond = shown.axes[0].scale / shown.a.frameTimeS;
    if ('factor' in turned) this.state.rows.zoomAbout(clip, frame, turned.factor);
    else this.state.rows.pan(clip, turned.pan / pixelsPerSecond);
  }
}

const isOnButton = ({ target }: Event): boolean =>
  target instanceof Element && target.closest('button') !== null;
