/** The time of the open clip and what moves it; what the timeline shows of it; the picture of the stage. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import type { PlaybackState } from '../app/store';
import { iconButton } from '../common/buttons';
import { loopControl, movers, speedMenu, zoomButtons, type LoopProps } from './time-controls';
import type { Zoom } from './zooming';

export interface TransportProps {
  readonly words: Words;
  readonly playback: PlaybackState;
  readonly frameTimeS: number;
  readonly lastFrame: number;
  readonly hasEarlierKeypose: boolean;
  readonly hasLaterKeypose: boolean;
  /** The ways in which the zoom can still go. */
  readonly zooms: Readonly<Record<Zoom, boolean>>;
  /** Whether the stage draws a picture that can be saved. */
  readonly picture: boolean;
  readonly onPlay: () => void;
  readonly onStep: (frames: 1 | -1) => void;
  readonly onKeypose: (direction: 1 | -1) => void;
  readonly onSpeed: (speed: number) => void;
  readonly onLoop: () => void;
  readonly onLoopClear: () => void;
  readonly onZoom: (way: Zoom) => void;
  readonly onPicture: () => void;
}

function clockFigures({
  words: { t, format },
  frameTimeS,
  playback,
  lastFrame,
}: TransportProps): TemplateResult {
  return html`<div class="clock">
    <span class="clock-time">${format.decimal(playback.frame * frameTimeS, 3)}</span
    ><span class="clock-unit">${t('unit.s')}</span>
    <span class="clock-frame"
      >${t('transport.frame', String(playback.frame))}
      <span class="clock-last">${t('transport.last', String(lastFrame))}</span></span
    >
  </div>`;
}

function viewButtons(props: TransportProps): TemplateResult {
  const { t } = props.words;
  const { picture, onPicture } = props;
  return html`
    ${zoomButtons({ ...props, all: t('transport.zoom-all') })}
    ${picture ? iconButton({ name: 'image', label: t('transport.picture'), onPress: onPicture }) : nothing}
  `;
}

function placeOf({ playback: { playing, frame }, lastFrame }: TransportProps) {
  return { playing, still: lastFrame === 0, atStart: frame === 0, atEnd: frame === lastFrame };
}

function rangeOf({ playback: { loop }, frameTimeS }: TransportProps): LoopProps['rangeS'] {
  return loop && [loop.a * frameTimeS, loop.b * frameTimeS];
}

export function transport(props: TransportProps): TemplateResult {
  const { words, playback, onSpeed } = props;
  return html`
    <div class="movers">${movers({ ...props, ...placeOf(props) })}</div>
    ${clockFigures(props)}
    <span class="rule"></span>
    <div class="transport-play">
      ${speedMenu({ id: 'speed-menu', words, speed: playback.speed, onSpeed })}
      ${loopControl({ ...props, looping: playback.looping, rangeS: rangeOf(props) })}
    </div>
    <div class="transport-view">${viewButtons(props)}</div>
  `;
}
