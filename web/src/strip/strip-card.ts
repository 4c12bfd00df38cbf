/** One keypose of the strip in: its figure, number and seconds on a button out, changed only where needed. */
import { element } from '../common/element';
import { drawFlatFigure } from '../figure/draw-flat-figure';
import type { FlatFigure } from '../figure/flat-figure';

const SVG_NAMESPACE = 'http://www.w3.org/2000/svg';
/** The common ground line of the figures, from the strip's upper edge. */
export const GROUND_Y = 72;

export interface CardProps {
  /** Middle and width of the card in pixels. */
  readonly x: number;
  readonly width: number;
  readonly number: string;
  readonly seconds: string;
  readonly spoken: string;
  readonly figure: FlatFigure | null;
  /** Pixels of one body height. */
  readonly scale: number;
}

export class StripCard {
  readonly button = element('button', 'keypose-card') as HTMLButtonElement;
  private readonly picture = document.createElementNS(SVG_NAMESPACE, 'svg');
  private readonly number = element('b', 'card-number');
  private readonly seconds = document.createTextNode('');
  private drawn: { figure: FlatFigure; scale: number } | null = null;

  constructor() {
    this.button.type = 'button';
    this.picture.setAttribute('aria-hidden', 'true');
    const label = element('span', 'card-label');
    label.append(this.number, this.seconds);
    this.button.append(this.picture, label);
  }

  update(props: CardProps): void {
    const { x, width, number, seconds, spoken } = props;
    this.button.style.transform = `translateX(${x - width / 2}px)`;
    this.button.style.width = `${width - 1}px`;
    this.number.textContent = number;
    this.seconds.data = ` ${seconds}`;
    // The words seen stand in the name as they are, for those who speak to their computer.
    this.button.setAttribute('aria-label', `${number} ${seconds}, ${spoken}`);
    this.draw(props);
  }

  setCurrent(current: boolean): void {
    this.button.classList.toggle('current', current);
    if (current) this.button.setAttribute('aria-current', 'true');
    else this.button.removeAttribute('aria-current');
  }

  private draw({ figure, scale }: CardProps): void {
    if (figure === null ? this.drawn === null : this.isDrawn(figure, scale)) return;
    this.picture.replaceChildren();
    this.drawn = figure && { figure, scale };
    if (figure === null) return;
    const x = (-scale * (figure.minX + figure.maxX)) / 2;
    drawFlatFigure(this.picture, figure, { scale, x, groundY: GROUND_Y });
  }

  private isDrawn(figure: FlatFigure, scale: number): boolean {
    return this.drawn?.figure === figure && this.drawn.scale === scale;
  }
}
