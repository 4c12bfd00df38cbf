/** Places of A's and B's moment in; the playhead that bends between them out, and its twin under the pointer. */
import { momentPath, type Places } from './ribbon';
import { rows, ROWS_HEIGHT } from './rows-layout';
import { svgElement } from './svg-element';

const FLAG_WIDTH = 46;
const FLAG_HEIGHT = 18;
/** How far the flags reach into the ribbon, on whose edges they stand. */
export const FLAG_REACH = FLAG_HEIGHT / 2;
const FLAG_A_Y = rows.ribbon.top - FLAG_REACH;
const FLAG_B_Y = rows.speedB.top - FLAG_REACH;
const TEXT_Y = 12.8;

export class PairPlayhead {
  readonly element = svgElement('svg', 'pair-playhead');
  private readonly line = svgElement('path', 'pair-now');
  private readonly twin = svgElement('path', 'pair-twin');
  private readonly flags = [new Flag(FLAG_A_Y), new Flag(FLAG_B_Y)];

  constructor(target: HTMLElement) {
    this.element.setAttribute('aria-hidden', 'true');
    this.element.setAttribute('height', String(ROWS_HEIGHT));
    this.element.append(this.twin, this.line, ...this.flags.map((flag) => flag.element));
    target.append(this.element);
  }

  show(xA: number, xB: number, textA: string, textB: string, width: number): void {
    this.element.setAttribute('width', String(width));
    this.line.setAttribute('d', momentPath([xA, xB]));
    this.flags[0].show(xA, textA, width);
    this.flags[1].show(xB, textB, width);
  }

  /** null: no pointer over the rows. */
  showTwin(places: Places | null): void {
    if (places) this.twin.setAttribute('d', momentPath(places));
    else this.twin.removeAttribute('d');
  }
}

/** Whether a place lies on the flag of A or of B, which is taken hold of there. */
export function isOnFlag(x: number, y: number, flags: Places): boolean {
  return [FLAG_A_Y, FLAG_B_Y].some(
    (top, clip) =>
      Math.abs(x - flags[clip]) <= FLAG_WIDTH / 2 && y >= top && y <= top + FLAG_HEIGHT,
  );
}

class Flag {
  readonly element = svgElement('g', 'pair-flag');
  private readonly text = svgElement('text');

  constructor(private readonly y: number) {
    const box = svgElement('rect');
    box.setAttribute('width', String(FLAG_WIDTH));
    box.setAttribute('height', String(FLAG_HEIGHT));
    box.setAttribute('rx', '4');
    this.text.setAttribute('x', String(FLAG_WIDTH / 2));
    this.text.setAttribute('y', String(TEXT_Y));
    this.element.append(box, this.text);
  }

  show(x: number, text: string, width: number): void {
    this.element.classList.toggle('outside', x < 0 || x > width);
    const left = Math.max(0, Math.min(x - FLAG_WIDTH / 2, width - FLAG_WIDTH));
    this.element.setAttribute('transform', `translate(${left} ${this.y})`);
    if (this.text.textContent !== text) this.text.textContent = text;
  }
}
