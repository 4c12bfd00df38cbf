/** Pointers and wheel over the rows in; the time they lead to, the moment they show and the zoom out. */
import { Touches } from '../timeline/touches';
import { turnOf } from '../timeline/wheel';
import type { TwoSignal } from './mount-rows';
import type { PairState } from './pair-state';
import { clipAt } from './rows-layout';

type Place = Pick<PointerEvent, 'clientX' | 'clientY'>;

type MomentOf = (event: Place) => { readonly clip: 0 | 1; readonly frame: number } | null;

export function listenToRows(area: HTMLElement, state: PairState, two: TwoSignal): void {
  const momentOf: MomentOf = (event) => {
    const shown = two.peek();
    if (!shown) return null;
    const box = area.getBoundingClientRect();
    const clip = clipAt(event.clientY - box.top);
    return { clip, frame: shown.axes[clip].frameAt(event.clientX - box.left) };
  };
  new RowsPointer(area, state, two, momentOf);
  const turn = (event: WheelEvent): void => {
    const turned = turnOf(event);
    const moment = momentOf(event);
    if (!turned || !moment) return;
    event.preventDefault();
    const { clip, frame } = moment;
    if ('factor' in turned) state.rows.zoomAbout(clip, frame, turned.factor);
    else state.rows.pan(clip, turned.pan / pixelsPerSecond(two));
  };
  area.addEventListener('wheel', turn, { passive: false });
}

function pixelsPerSecond(two: TwoSignal): number {
  const shown = two.peek();
  return shown ? shown.axes[0].scale / shown.a.frameTimeS : 1;
}

class RowsPointer {
  private readonly touches = new Touches();
  /** Whose time a drag moves: it stays the one where the drag began. */
  private dragged: 0 | 1 | null = null;

  constructor(
    private readonly area: HTMLElement,
    private readonly state: PairState,
    private readonly two: TwoSignal,
    private readonly momentOf: MomentOf,
  ) {
    area.addEventListener('pointerdown', (event) => this.press(event));
    area.addEventListener('pointermove', (event) => this.move(event));
    for (const type of ['lostpointercapture', 'pointercancel'] as const)
      area.addEventListener(type, (event) => this.end(event));
    area.addEventListener('pointerleave', () => {
      state.hovered.value = null;
    });
  }

  private press(event: PointerEvent): void {
    const moment = this.momentOf(event);
    if (event.button !== 0 || isOnButton(event) || !moment) return;
    this.area.setPointerCapture(event.pointerId);
    this.state.hovered.value = null;
    if (event.pointerType === 'touch') this.touches.put(event.pointerId, this.xOf(event));
    this.dragged = this.touches.count > 1 ? null : moment.clip;
    this.drag(event);
  }

  private move(event: PointerEvent): void {
    if (this.touches.count > 1) return this.pinch(event);
    if (this.touches.has(event.pointerId)) this.touches.put(event.pointerId, this.xOf(event));
    if (this.dragged !== null) this.drag(event);
    else if (!isOnButton(event)) this.state.hovered.value = this.momentOf(event);
  }

  private end({ pointerId }: PointerEvent): void {
    this.touches.lift(pointerId);
    this.dragged = null;
  }

  private drag(event: PointerEvent): void {
    const { dragged } = this;
    const axis = dragged === null ? undefined : this.two.peek()?.axes[dragged];
    if (axis) this.state.clock.seek(dragged!, axis.frameAt(this.xOf(event)));
  }

  /** What a finger that stays touches keeps its place. */
  private pinch(event: PointerEvent): void {
    const spread = this.touches.move(event.pointerId, this.xOf(event));
    const { left } = this.area.getBoundingClientRect();
    const moment =
      spread && this.momentOf({ clientX: left + spread.about, clientY: event.clientY });
    if (moment) this.state.rows.zoomAbout(moment.clip, moment.frame, spread.factor);
  }

  private xOf({ clientX }: PointerEvent): number {
    return clientX - this.area.getBoundingClientRect().left;
  }
}

const isOnButton = ({ target }: Event): boolean =>
  target instanceof Element && target.closest('button') !== null;
