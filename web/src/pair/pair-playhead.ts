/** Places of A's and B's moment in; the playhead that bends between them out, and its twin under the pointer. */
import { bend } from './ribbon';
import { rows, ROWS_HEIGHT } from './rows-layout';

const SVG_NAMESPACE = 'http://www.w3.org/2000/svg';
const FLAG_WIDTH = 46;
const FLAG_HEIGHT = 18;
const FLAG_A_Y = rows.ribbon.top - FLAG_HEIGHT + 9;
const FLAG_B_Y = rows.speedB.top - 9;
const TEXT_Y = 12.8;

export class PairPlayhead {
  readonly element = svg('svg', 'pair-playhead');
  private readonly line = svg('path', 'pair-now');
  private readonly twin = svg('path', 'pair-twin');
  private readonly flags = [new Flag(FLAG_A_Y), new Flag(FLAG_B_Y)];

  constructor(target: HTMLElement) {
    this.element.setAttribute('aria-hidden', 'true');
    this.element.setAttribute('height', String(ROWS_HEIGHT));
    this.element.append(this.twin, this.line, ...this.flags.map((flag) => flag.element));
    target.append(this.element);
  }

  show(xA: number, xB: number, textA: string, textB: string, width: number): void {
    this.element.setAttribute('width', String(width));
    this.line.setAttribute('d', pathOf(xA, xB));
    this.flags[0].show(xA, textA, width);
    this.flags[1].show(xB, textB, width);
  }

  /** null: no pointer over the rows. */
  showTwin(places: readonly [number, number] | null): void {
    if (places) this.twin.setAttribute('d', pathOf(...places));
    else this.twin.removeAttribute('d');
  }
}

/** From A's pins to B's, and on over what is told on B's time. */
function pathOf(xA: number, xB: number): string {
  const { pinsA, ribbon, speedB, pinsB, ahead } = rows;
  const above = `M${xA} ${pinsA.top + 2}V${ribbon.top}`;
  const below = `M${xB} ${speedB.top}V${pinsB.top + pinsB.height}M${xB} ${ahead.top + 1}V${ROWS_HEIGHT}`;
  return above + bend(xA, xB) + below;
}

class Flag {
  readonly element = svg('g', 'pair-flag');
  private readonly text = svg('text', '');

  constructor(private readonly y: number) {
    const box = svg('rect', '');
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

function svg(name: string, className: string): SVGElement {
  const node = document.createElementNS(SVG_NAMESPACE, name);
  if (className !== '') node.setAttribute('class', className);
  return node;
}
