/** The ruler: ticks with seconds and frames. */
import type { Axis } from './axis';
import { rulerTicks, type Tick } from './ruler-layout';
import type { TimelineText } from './timeline-text';

const LABEL_WIDTH = 70;
const FLAG_HALF_WIDTH = 26;

export class Ruler {
  readonly element = document.createElement('div');
  private labels: { readonly x: number; readonly node: HTMLElement }[] = [];

  constructor() {
    this.element.className = 'ruler';
    this.element.setAttribute('aria-hidden', 'true');
  }

  update(axis: Axis, frameTimeS: number, text: TimelineText): void {
    this.element.replaceChildren();
    this.labels = [];
    for (const tick of axis.width > 0 ? rulerTicks(axis, frameTimeS) : []) {
      this.element.append(tickMark(tick));
      if (tick.size === 'major' && tick.x + LABEL_WIDTH < axis.width) this.label(tick, text);
    }
  }

  /** Hides the labels that the playhead's flag at `x` would cover. */
  makeRoom(x: number): void {
    for (const { x: left, node } of this.labels) {
      node.classList.toggle(
        'covered',
        left < x + FLAG_HALF_WIDTH && left + LABEL_WIDTH > x - FLAG_HALF_WIDTH,
      );
    }
  }

  private label(tick: Tick, text: TimelineText): void {
    const node = document.createElement('span');
    const frame = document.createElement('small');
    node.className = 'ruler-label';
    node.textContent = rulerTime(tick.timeS, text);
    frame.textContent = text.count(tick.frame);
    node.append(frame);
    node.style.left = `${tick.x + 4}px`;
    this.labels.push({ x: tick.x, node });
    this.element.append(node);
  }
}

function tickMark(tick: Tick): HTMLElement {
  const mark = document.createElement('i');
  mark.className = `tick ${tick.size}`;
  mark.style.left = `${tick.x}px`;
  return mark;
}

/** "0.5 s" below a minute, "1:30" from there on. */
export function rulerTime(timeS: number, text: Pick<TimelineText, 'seconds'>): string {
  if (timeS < 60) return `${text.seconds(timeS, Number.isInteger(timeS) ? 0 : 1)} s`;
  const minutes = Math.floor(timeS / 60);
  return `${minutes}:${String(Math.round(timeS - 60 * minutes)).padStart(2, '0')}`;
}
