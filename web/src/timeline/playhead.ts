/** The playhead and its dashed twin under the pointer: lines through all rows with their time in a flag. */
import { element } from '../common/element';
import type { Axis } from './axis';
import type { TimelineText } from './timeline-text';

const DIGIT = 6.8;
const FLAG_WIDTH = 46;
const FLAG_PADDING = 8;
const AIR = 3;

export class Playhead {
  readonly line = element('div', 'playhead');
  readonly twin = element('div', 'hover-line');
  readonly flag = element('div', 'playhead-flag');
  private readonly twinFlag = element('div', 'hover-flag');

  constructor() {
    this.line.append(this.flag);
    this.twin.append(this.twinFlag);
    this.line.tabIndex = 0;
    this.line.setAttribute('role', 'slider');
    this.line.setAttribute('aria-valuemin', '0');
  }

  update(axis: Axis, text: TimelineText): void {
    this.line.setAttribute('aria-label', text.playhead);
    this.line.setAttribute('aria-valuemax', String(axis.lastFrame));
  }

  move(axis: Axis, frame: number, frameTimeS: number, text: TimelineText): void {
    write(this.flag, text.seconds(frame * frameTimeS, 3));
    place(axis, this.line, this.flag, frame);
    this.line.setAttribute('aria-valuenow', String(frame));
    this.line.setAttribute('aria-valuetext', text.moment(frame, frame * frameTimeS));
  }

  moveTwin(axis: Axis, frame: number | null, frameTimeS: number, text: TimelineText): void {
    this.twin.hidden = frame === null;
    if (frame === null) return;
    write(this.twinFlag, text.seconds(frame * frameTimeS, 3));
    place(axis, this.twin, this.twinFlag, frame);
  }
}

/** Puts a line at a frame; its flag stays within the axis, and neither shows where the frame does not. */
function place(axis: Axis, line: HTMLElement, flag: HTMLElement, frame: number): void {
  const x = axis.x(frame);
  const half = flagHalfWidth(flag.textContent);
  const inside = Math.min(axis.width - half, Math.max(half, x));
  line.style.transform = `translateX(${x}px)`;
  flag.style.marginLeft = `${inside - x}px`;
  line.classList.toggle('outside', x < -1 || x > axis.width + 1);
}

/** Half the width of a time flag and a little air, without asking the page, which would lay it out anew. */
export function flagHalfWidth(words: string): number {
  return Math.max(FLAG_WIDTH, words.length * DIGIT + FLAG_PADDING) / 2 + AIR;
}

function write(node: HTMLElement, words: string): void {
  if (node.textContent !== words) node.textContent = words;
}
