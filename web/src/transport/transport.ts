/** The time of the open clip and what moves it; what the timeline shows of it; the picture of the stage. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import type { PlaybackState } from '../app/store';
import { iconButton, type IconButton } from '../common/buttons';
import { icon } from '../common/icons';
import { menuButton } from '../common/menu';
import { SPEED_STEPS, type LoopRange } from '../player/clock';
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

function speedMenu({ words: { t, format }, playback, onSpeed }: TransportProps): TemplateResult {
  const times = (speed: number): string => t('transport.times', format.short(speed, 2));
  return menuButton({
    id: 'speed-menu',
    name: 'gauge',
    label: t('transport.speed'),
    text: times(playback.speed),
    keys: '- +',
    keyText: '- +',
    items: SPEED_STEPS.map((speed) => ({
      label: times(speed),
      checked: speed === playback.speed,
      onChoose: () => onSpeed(speed),
    })),
  });
}

function rangeText({ words: { t, format }, frameTimeS }: TransportProps, range: LoopRange): string {
  const seconds = (frame: number): string => format.decimal(frame * frameTimeS, 2);
  return t('transport.range', seconds(range.a), seconds(range.b));
}

function loopControl(props: TransportProps): TemplateResult {
  const {
    words: { t },
    playback: { looping, loop },
  } = props;
  const range = loop && html`<span class="loop-range">${rangeText(props, loop)}</span>`;
  return html`<button
      type="button"
      class="button ghost loop ${looping ? 'on' : ''}"
      aria-pressed=${String(looping)}
      aria-keyshortcuts="L"
      data-tip=${t('transport.loop.tip')}
      data-key="L"
      @click=${props.onLoop}
    >
      ${icon('repeat', 15)}<span>${t(loop ? 'transport.ab' : 'transport.loop')}</span>
      ${range ?? nothing}
    </button>
    ${
      loop
        ? iconButton({
            name: 'x',
            label: t('transport.loop.clear'),
            size: 14,
            small: true,
            keys: 'Shift+L',
            keyText: `${t('key.shift')} L`,
            onPress: props.onLoopClear,
          })
        : nothing
    }`;
}

function viewButtons({
  words: { t },
  zooms,
  picture,
  onZoom,
  onPicture,
}: TransportProps): TemplateResult {
  const button = (way: Zoom, values: Omit<IconButton, 'disabled' | 'onPress'>): TemplateResult =>
    iconButton({ ...values, disabled: !zooms[way], onPress: () => onZoom(way) });
  return html`
    ${button('out', { name: 'zoom-out', label: t('transport.zoom-out'), keys: 'Shift+Z', keyText: `${t('key.shift')} Z` })}
    ${button('in', { name: 'zoom-in', label: t('transport.zoom-in'), keys: 'Z', keyText: 'Z' })}
    ${button('all', { name: 'unfold-horizontal', label: t('transport.zoom-all'), keys: '0', keyText: '0' })}
    ${picture ? iconButton({ name: 'image', label: t('transport.picture'), onPress: onPicture }) : nothing}
  `;
}

export function transport(props: TransportProps): TemplateResult {
  return html`
    <div class="movers">${movers(props)}</div>
    ${clockFigures(props)}
    <span class="rule"></span>
    <div class="transport-play">${speedMenu(props)} ${loopControl(props)}</div>
    <div class="transport-view">${viewButtons(props)}</div>
  `;
}
