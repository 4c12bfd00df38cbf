/** The ends of the A–B loop as two tabs that are moved by pointer and keys; the loop that comes of it out. */
import { element } from '../common/element';
import type { LoopRange } from '../player/clock';
import type { Axis } from './axis';
import { endAfterKey, withEnd, type LoopEnd } from './loop-range';
import type { TimelineText } from './timeline-text';

export interface LoopEvents {
  onLoop(range: LoopRange): void;
}

export interface LoopState {
  readonly axis: Axis;
  /** In frames, which need not be whole. */
  readonly loop: LoopRange | null;
  readonly looping: boolean;
  readonly frameTimeS: number;
}

export type LoopText = Pick<TimelineText, 'loopStart' | 'loopEnd' | 'loopTip' | 'moment'>;

const TENTH_S = 0.1;
/** Ends nearer than two tabs are wide have theirs on the outer sides: neither hides the other. */
const NARROW = 28;

export class LoopTabs {
  readonly a = element('div', 'loop-tab a');
  readonly b = element('div', 'loop-tab b');
  private state: LoopState | null = null;

  constructor(private readonly events: LoopEvents) {
    for (const end of ['a', 'b'] as const) {
      const tab = this[end];
      tab.textContent = end.toUpperCase();
      tab.tabIndex = 0;
      tab.setAttribute('role', 'slider');
      tab.setAttribute('aria-valuemin', '0');
      tab.addEventListener('keydown', (event) => this.press(event, end));
      tab.addEventListener('pointerdown', (event) => this.grab(event, end));
    }
  }

  update(state: LoopState, text: LoopText): void {
    this.state = state;
    const { axis, loop, looping } = state;
    const narrow = loop !== null && axis.x(loop.b) - axis.x(loop.a) < NARROW;
    for (const end of ['a', 'b'] as const) {
      this[end].hidden = loop === null;
      this[end].classList.toggle('narrow', narrow);
      this[end].classList.toggle('off', !looping);
      if (loop !== null) this.place(end, loop[end], state, text);
    }
  }

  private place(
    end: LoopEnd,
    frame: number,
    { axis, frameTimeS }: LoopState,
    text: LoopText,
  ): void {
    const tab = this[end];
    const x = axis.x(frame);
    tab.style.transform = `translateX(${x}px)`;
    tab.classList.toggle('outside', x < -1 || x > axis.width + 1);
    tab.setAttribute('aria-label', end === 'a' ? text.loopStart : text.loopEnd);
    tab.setAttribute('aria-valuemax', String(axis.lastFrame));
    tab.setAttribute('aria-valuenow', String(Math.round(frame)));
    tab.setAttribute('aria-valuetext', text.moment(Math.round(frame), frame * frameTimeS));
    tab.dataset['tip'] = text.loopTip;
  }

  private press(event: KeyboardEvent, end: LoopEnd): void {
    if (!this.state?.loop || event.ctrlKey || event.metaKey || event.altKey) return;
    const { axis, loop, frameTimeS } = this.state;
    const tenth = Math.round(TENTH_S / frameTimeS);
    const frame = endAfterKey(event.key, event.shiftKey, loop[end], axis.lastFrame, tenth);
    if (frame === null) return;
    event.preventDefault();
    event.stopPropagation();
    const moved = withEnd(loop, end, frame, axis.lastFrame);
    if (moved === null) return;
    if (moved[end] === loop[end]) this[end === 'a' ? 'b' : 'a'].focus();
    // Keys may come faster than the page draws: they go on from here.
    this.state = { ...this.state, loop: moved };
    this.events.onLoop(moved);
  }

  private grab(event: PointerEvent, end: LoopEnd): void {
    if (event.button !== 0 || !this.state?.loop) return;
    event.stopPropagation();
    const tab = this[end];
    const still = this.state.loop;
    const left = event.clientX - this.state.axis.x(still[end]);
    tab.setPointerCapture(event.pointerId);
    const drag = ({ clientX }: PointerEvent): void => {
      const { axis } = this.state!;
      const moved = withEnd(still, end, axis.placeAt(clientX - left), axis.lastFrame);
      if (moved !== null) this.events.onLoop(moved);
    };
    const drop = (): void => {
      tab.removeEventListener('pointermove', drag);
      tab.removeEventListener('lostpointercapture', drop);
    };
    tab.addEventListener('pointermove', drag);
    tab.addEventListener('lostpointercapture', drop);
  }
}
