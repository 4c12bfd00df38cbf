/** The A–B loop: a band over the rows, and at its ends on the ruler two tabs that can be moved. */
import { element } from '../common/element';
import type { LoopRange } from '../player/clock';
import type { Axis } from './axis';
import { endAfterKey, withEnd, type LoopEnd } from './loop-range';
import type { RowLayout } from './rows';
import type { TimelineText } from './timeline-text';

export interface LoopEvents {
  onLoop(range: LoopRange): void;
}

interface LoopState {
  readonly axis: Axis;
  readonly loop: LoopRange | null;
  readonly frameTimeS: number;
}

const TENTH_S = 0.1;

export class LoopBand {
  readonly band = element('div', 'loop-band');
  readonly tabs: Readonly<Record<LoopEnd, HTMLElement>> = {
    a: element('div', 'loop-tab a'),
    b: element('div', 'loop-tab b'),
  };
  private state: LoopState | null = null;

  constructor(private readonly events: LoopEvents) {
    for (const end of ['a', 'b'] as const) {
      const tab = this.tabs[end];
      tab.textContent = end.toUpperCase();
      tab.tabIndex = 0;
      tab.setAttribute('role', 'slider');
      tab.setAttribute('aria-valuemin', '0');
      tab.addEventListener('keydown', (event) => this.press(event, end));
      tab.addEventListener('pointerdown', (event) => this.grab(event, end));
    }
  }

  update(
    axis: Axis,
    rows: RowLayout,
    loop: LoopRange | null,
    looping: boolean,
    frameTimeS: number,
    text: TimelineText,
  ): void {
    this.state = { axis, loop, frameTimeS };
    const { band, tabs } = this;
    for (const node of [band, tabs.a, tabs.b]) {
      node.hidden = loop === null;
      node.classList.toggle('off', !looping);
    }
    if (loop === null) return;
    const [left, right] = [axis.x(loop.a), axis.x(loop.b)];
    band.style.top = `${rows.ruler.top}px`;
    band.style.height = `${rows.spanHeight - rows.ruler.top}px`;
    band.style.left = `${left}px`;
    band.style.width = `${right - left}px`;
    this.placeTab('a', left, loop.a, text);
    this.placeTab('b', right, loop.b, text);
  }

  /** Whether a pixel lies in the band. */
  covers(x: number): boolean {
    if (!this.state?.loop) return false;
    const { axis, loop } = this.state;
    return x >= axis.x(loop.a) && x <= axis.x(loop.b);
  }

  private placeTab(end: LoopEnd, x: number, frame: number, text: TimelineText): void {
    const { axis, frameTimeS } = this.state!;
    const tab = this.tabs[end];
    tab.style.transform = `translateX(${x}px)`;
    tab.classList.toggle('outside', x < -1 || x > axis.width + 1);
    tab.setAttribute('aria-label', end === 'a' ? text.loopStart : text.loopEnd);
    tab.setAttribute('aria-valuemax', String(axis.lastFrame));
    tab.setAttribute('aria-valuenow', String(frame));
    tab.setAttribute('aria-valuetext', text.moment(frame, frame * frameTimeS));
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
    if (moved[end] === loop[end]) this.tabs[end === 'a' ? 'b' : 'a'].focus();
    // Keys may come faster than the page draws: they go on from here.
    this.state = { ...this.state, loop: moved };
    this.events.onLoop(moved);
  }

  private grab(event: PointerEvent, end: LoopEnd): void {
    if (event.button !== 0 || !this.state?.loop) return;
    event.stopPropagation();
    const tab = this.tabs[end];
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
