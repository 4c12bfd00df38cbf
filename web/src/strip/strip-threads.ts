/** Cards and pins in; the threads between them and the ground line of the figures out. */
import { GROUND_Y } from './strip-card';
import type { Card } from './strip-layout';

const SVG_NAMESPACE = 'http://www.w3.org/2000/svg';
const STRIP_HEIGHT = 106;
const THREAD_HEIGHT = 14;
/** Pixels from the strip's lower edge to the middle of the pins. */
const PIN_MIDDLE = 12;

export class StripThreads {
  readonly element = document.createElementNS(SVG_NAMESPACE, 'svg');
  private readonly ground = this.path('strip-ground');
  private readonly threads = new Map<number, SVGPathElement>();

  constructor() {
    this.element.setAttribute('class', 'strip-threads');
    this.element.setAttribute('aria-hidden', 'true');
    this.element.setAttribute('height', String(STRIP_HEIGHT + THREAD_HEIGHT + PIN_MIDDLE));
    this.element.append(this.ground);
  }

  /** `pinX`: where the pin of each keypose stands. */
  update(cards: readonly Card[], pinX: ArrayLike<number>, width: number): void {
    this.element.setAttribute('width', String(width));
    this.ground.setAttribute('d', `M0 ${GROUND_Y + 0.5}H${width}`);
    const shown = new Set(cards.map(({ keypose }) => keypose));
    for (const [keypose, path] of this.threads) {
      if (shown.has(keypose)) continue;
      path.remove();
      this.threads.delete(keypose);
    }
    for (const { keypose, x } of cards)
      this.thread(keypose).setAttribute('d', threadPath(x, pinX[keypose]));
  }

  /** The current one lies above the others. */
  markCurrent(current: number | null): void {
    for (const [keypose, path] of this.threads)
      path.classList.toggle('current', keypose === current);
    const path = current === null ? undefined : this.threads.get(current);
    if (path && path !== this.element.lastChild) this.element.append(path);
  }

  private thread(keypose: number): SVGPathElement {
    let path = this.threads.get(keypose);
    if (path === undefined) {
      path = this.path('thread');
      this.threads.set(keypose, path);
      this.element.append(path);
    }
    return path;
  }

  private path(className: string): SVGPathElement {
    const path = document.createElementNS(SVG_NAMESPACE, 'path');
    path.setAttribute('class', className);
    return path;
  }
}

function threadPath(cardX: number, pinX: number): string {
  const [top, bottom] = [STRIP_HEIGHT - 2, STRIP_HEIGHT + THREAD_HEIGHT + 6];
  return `M${cardX} ${top}C${cardX} ${top + 15} ${pinX} ${top + 7} ${pinX} ${bottom}`;
}
