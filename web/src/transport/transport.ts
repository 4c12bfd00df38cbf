/** The time of the open clip and what moves it. */
import { html, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import type { PlaybackState } from '../app/store';
import { iconButton, type IconButton } from '../common/buttons';
import { icon } from '../common/icons';
import { MAXIMUM_SPEED, MINIMUM_SPEED } from '../player/clock';

export interface TransportProps {
  readonly words: Words;
  readonly playback: PlaybackState;
  readonly timeS: number;
  readonly lastFrame: number;
  readonly hasEarlierKeypose: boolean;
  readonly hasLaterKeypose: boolean;
  readonly onPlay: () => void;
  readonly onStep: (frames: 1 | -1) => void;
  readonly onKeypose: (direction: 1 | -1) => void;
  readonly onSpeed: (direction: 1 | -1) => void;
  readonly onLoop: () => void;
}

function playButton({ words: { t }, playback, lastFrame, onPlay }: TransportProps): TemplateResult {
  const label = t(playback.playing ? 'transport.pause' : 'transport.play');
  return html`<button
    type="button"
    class="play-button"
    aria-label=${label}
    data-tip=${label}
    data-key=${t('help.space')}
    aria-keyshortcuts="Space"
    ?disabled=${lastFrame === 0}
    @click=${onPlay}
  >
    ${icon(playback.playing ? 'pause' : 'play', 15)}
  </button>`;
}

function movers(props: TransportProps): TemplateResult {
  const { t } = props.words;
  const still = props.lastFrame === 0;
  const { frame } = props.playback;
  const button = (values: IconButton): TemplateResult => iconButton(values);
  return html`
    ${button({ name: 'previous-keypose', size: 18, label: t('transport.previous-keypose'), keys: 'Shift+K', keyText: `${t('key.shift')} K`, disabled: !props.hasEarlierKeypose, onPress: () => props.onKeypose(-1) })}
    ${button({ name: 'step-back', size: 15, label: t('transport.back'), keys: 'ArrowLeft', keyText: '←', disabled: still || frame === 0, onPress: () => props.onStep(-1) })}
    ${playButton(props)}
    ${button({ name: 'step-forward', size: 15, label: t('transport.on'), keys: 'ArrowRight', keyText: '→', disabled: still || frame === props.lastFrame, onPress: () => props.onStep(1) })}
    ${button({ name: 'next-keypose', size: 18, label: t('transport.next-keypose'), keys: 'K', keyText: 'K', disabled: !props.hasLaterKeypose, onPress: () => props.onKeypose(1) })}
  `;
}

function clockFigures({
  words: { t, format },
  timeS,
  playback,
  lastFrame,
}: TransportProps): TemplateResult {
  return html`<div class="clock">
    <span class="clock-time">${format.decimal(timeS, 3)}</span
    ><span class="clock-unit">${t('unit.s')}</span>
    <span class="clock-frame"
      >${t('transport.frame', String(playback.frame))}
      <span class="clock-last">${t('transport.last', String(lastFrame))}</span></span
    >
  </div>`;
}

function speedControl({ words: { t, format }, playback, onSpeed }: TransportProps): TemplateResult {
  return html`<div class="speed" role="group" aria-label=${t('transport.speed')}>
    ${iconButton({ name: 'minus', label: t('transport.slower'), size: 14, small: true, keys: '-', keyText: '-', disabled: playback.speed <= MINIMUM_SPEED, onPress: () => onSpeed(-1) })}
    <output class="speed-figure">${t('transport.times', format.short(playback.speed, 2))}</output>
    ${iconButton({ name: 'plus', label: t('transport.faster'), size: 14, small: true, keys: '+', keyText: '+', disabled: playback.speed >= MAXIMUM_SPEED, onPress: () => onSpeed(1) })}
  </div>`;
}

function loopButton({ words: { t }, playback, onLoop }: TransportProps): TemplateResult {
  return html`<button
    type="button"
    class="button ghost loop ${playback.looping ? 'on' : ''}"
    aria-pressed=${String(playback.looping)}
    aria-keyshortcuts="L"
    data-tip=${t('transport.loop')}
    data-key="L"
    @click=${onLoop}
  >
    ${icon('repeat', 15)}<span>${t('transport.loop')}</span>
  </button>`;
}

export function transport(props: TransportProps): TemplateResult {
  return html`
    <div class="movers">${movers(props)}</div>
    ${clockFigures(props)}
    <span class="rule"></span>
    ${speedControl(props)} ${loopButton(props)}
  `;
}
