/** The one time of the pair in; what moves it, and the times of A and B, out. */
import { html, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { loopControl, movers, speedMenu, zoomButtons } from '../transport/time-controls';
import type { Zoom } from '../transport/zooming';
import type { PairMoment } from './pair-clock';

export interface PairTransportProps {
  readonly words: Words;
  readonly moment: PairMoment;
  /** Of A and B. */
  readonly timesS: readonly [number, number];
  /** Of A, between which it loops; null: all of it. */
  readonly rangeS: readonly [number, number] | null;
  readonly atStart: boolean;
  readonly atEnd: boolean;
  readonly hasEarlierKeypose: boolean;
  readonly hasLaterKeypose: boolean;
  /** The ways in which the zoom of the rows can still go. */
  readonly zooms: Readonly<Record<Zoom, boolean>>;
  readonly onPlay: () => void;
  readonly onStep: (direction: 1 | -1) => void;
  readonly onKeypose: (direction: 1 | -1) => void;
  readonly onSpeed: (speed: number) => void;
  readonly onLoop: () => void;
  readonly onLoopClear: () => void;
  readonly onZoom: (way: Zoom) => void;
}

function times({ words: { t, format }, timesS }: PairTransportProps): TemplateResult {
  return html`<div class="clock pair-clock">
    ${timesS.map(
      (timeS, i) =>
        html`<span class="clock-time">${format.decimal(timeS, 2)}</span
          ><span class="clock-unit">${t('pair.seconds-of', 'AB'[i])}</span>`,
    )}
  </div>`;
}

export function pairTransport(props: PairTransportProps): TemplateResult {
  const { words, moment, onSpeed } = props;
  const { playing, looping, speed } = moment;
  return html`
    <div class="movers">${movers({ ...props, playing, still: false })}</div>
    ${times(props)}
    <span class="rule"></span>
    <div class="transport-play">
      ${speedMenu({ id: 'pair-speed-menu', words, speed, onSpeed })}
      ${loopControl({ ...props, looping })}
    </div>
    <div class="transport-view">${zoomButtons({ ...props, all: words.t('pair.zoom-all') })}</div>
    <div class="pair-legend">
      <span>${words.t('pair.difference')}</span><span class="pair-legend-bar"></span>
    </div>
  `;
}
