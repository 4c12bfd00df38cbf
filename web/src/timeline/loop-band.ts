/** The A–B loop: a band over the rows, and at its ends on the ruler two tabs that can be moved. */
import { element } from '../common/element';
import type { LoopRange } from '../player/clock';
import type { Axis } from './axis';
import { LoopTabs, type LoopEvents, type LoopText } from './loop-tabs';
import type { RowLayout } from './rows';

export class LoopBand {
  readonly band = element('div', 'loop-band');
  readonly tabs: LoopTabs;
  private shown: { readonly axis: Axis; readonly loop: LoopRange } | null = null;

  constructor(events: LoopEvents) {
    this.tabs = new LoopTabs(events);
  }

  update(
    axis: Axis,
    rows: RowLayout,
    loop: LoopRange | null,
    looping: boolean,
    frameTimeS: number,
    text: LoopText,
  ): void {
    this.shown = loop && { axis, loop };
    this.tabs.update({ axis, loop, looping, frameTimeS }, text);
    const { band } = this;
    band.hidden = loop === null;
    band.classList.toggle('off', !looping);
    if (loop === null) return;
    const [left, right] = [axis.x(loop.a), axis.x(loop.b)];
    band.style.top = `${rows.ruler.top}px`;
    band.style.height = `${rows.spanHeight - rows.ruler.top}px`;
    band.style.left = `${left}px`;
    band.style.width = `${right - left}px`;
  }

  /** Whether a pixel lies in the band. */
  covers(x: number): boolean {
    if (!this.shown) return false;
    const { axis, loop } = this.shown;
    return x >= axis.x(loop.a) && x <= axis.x(loop.b);
  }
}
