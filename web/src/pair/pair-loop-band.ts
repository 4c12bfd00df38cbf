/** A loop's ends and the axes of A and B in; a band over the rows, tabs at its ends on both rulers out. */
import type { LoopRange } from '../player/clock';
import { LoopTabs, type LoopText } from '../timeline/loop-tabs';
import { FLAG_REACH } from './pair-playhead';
import { bandPath, momentPath, type Places } from './ribbon';
import { rows, ROWS_HEIGHT } from './rows-layout';
import { svgElement } from './svg-element';
import type { Two } from './two';

export interface PairLoopEvents {
  /** In frames of the clip. */
  onLoop(clip: 0 | 1, range: LoopRange): void;
}

/** Of A and of B, in frames. */
export type LoopRanges = readonly [LoopRange, LoopRange];

export class PairLoopBand {
  private readonly svg = svgElement('svg', 'pair-graph');
  private readonly band = svgElement('path', 'pair-loop');
  private readonly ends = svgElement('path', 'pair-loop-ends');
  private readonly tabs: readonly [LoopTabs, LoopTabs];

  constructor(
    private readonly target: HTMLElement,
    events: PairLoopEvents,
  ) {
    this.tabs = [
      new LoopTabs({ onLoop: (range) => events.onLoop(0, range) }),
      new LoopTabs({ onLoop: (range) => events.onLoop(1, range) }),
    ];
    this.svg.setAttribute('aria-hidden', 'true');
    this.svg.setAttribute('height', String(ROWS_HEIGHT));
    this.svg.append(this.band, this.ends);
    target.append(this.svg);
  }

  /** Over what has come since, beside the flags of time. */
  raiseTabs(): void {
    const { top, height } = rows.ribbon;
    const topA = top + FLAG_REACH;
    const topB = top + height - FLAG_REACH - TAB_HEIGHT;
    this.tabs.forEach(({ a, b }, clip) => {
      for (const tab of [a, b]) {
        tab.classList.add('pair-loop-tab');
        tab.style.top = `${clip === 0 ? topA : topB}px`;
        this.target.append(tab);
      }
    });
  }

  update(
    two: Two,
    loops: LoopRanges | null,
    looping: boolean,
    texts: readonly [LoopText, LoopText],
  ): void {
    const { axes, a, b } = two;
    this.svg.setAttribute('width', String(axes[0].width));
    for (const part of [this.band, this.ends]) part.classList.toggle('off', !looping);
    [a, b].forEach(({ frameTimeS }, clip) => {
      const loop = loops?.[clip] ?? null;
      this.tabs[clip].update({ axis: axes[clip], loop, looping, frameTimeS }, texts[clip]);
    });
    this.svg.classList.toggle('outside', !loops);
    if (!loops) return;
    const places = (end: 'a' | 'b'): Places => [axes[0].x(loops[0][end]), axes[1].x(loops[1][end])];
    const [from, to] = [places('a'), places('b')];
    this.band.setAttribute('d', bandPath(from, to));
    this.ends.setAttribute('d', momentPath(from) + momentPath(to));
  }
}

const TAB_HEIGHT = 16;
