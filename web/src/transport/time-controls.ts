/** What moves a time, of one clip or of several on one clock, in; its buttons, speeds and loop out. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { iconButton, type IconButton } from '../common/buttons';
import { icon } from '../common/icons';
import { menuButton } from '../common/menu';
import { SPEED_STEPS } from '../player/clock';
import type { Zoom } from './zooming';

export interface MoverProps {
  readonly words: Words;
  readonly playing: boolean;
  /** There is but one frame. */
  readonly still: boolean;
  readonly atStart: boolean;
  readonly atEnd: boolean;
  readonly hasEarlierKeypose: boolean;
  readonly hasLaterKeypose: boolean;
  readonly onPlay: () => void;
  readonly onStep: (frames: 1 | -1) => void;
  readonly onKeypose: (direction: 1 | -1) => void;
}

function playButton({ words: { t }, playing, still, onPlay }: MoverProps): TemplateResult {
  const label = t(playing ? 'transport.pause' : 'transport.play');
  return html`<button
    type="button"
    class="play-button"
    aria-label=${label}
    data-tip=${label}
    data-key=${t('help.space')}
    aria-keyshortcuts="Space"
    ?disabled=${still}
    @click=${onPlay}
  >
    ${icon(playing ? 'pause' : 'play', 15)}
  </button>`;
}

export function movers(props: MoverProps): TemplateResult {
  const { t } = props.words;
  const { still } = props;
  const button = (values: IconButton): TemplateResult => iconButton(values);
  return html`
    ${button({ name: 'previous-keypose', size: 18, label: t('transport.previous-keypose'), keys: 'Shift+K', keyText: `${t('key.shift')} K`, disabled: !props.hasEarlierKeypose, onPress: () => props.onKeypose(-1) })}
    ${button({ name: 'step-back', size: 15, label: t('transport.back'), keys: 'ArrowLeft', keyText: '←', disabled: still || props.atStart, onPress: () => props.onStep(-1) })}
    ${playButton(props)}
    ${button({ name: 'step-forward', size: 15, label: t('transport.on'), keys: 'ArrowRight', keyText: '→', disabled: still || props.atEnd, onPress: () => props.onStep(1) })}
    ${button({ name: 'next-keypose', size: 18, label: t('transport.next-keypose'), keys: 'K', keyText: 'K', disabled: !props.hasLaterKeypose, onPress: () => props.onKeypose(1) })}
  `;
}

export interface SpeedProps {
  /** Of the menu in the page. */
  readonly id: string;
  readonly words: Words;
  readonly speed: number;
  readonly onSpeed: (speed: number) => void;
}

export function speedMenu({ id, words: { t, format }, speed, onSpeed }: SpeedProps) {
  const times = (value: number): string => t('transport.times', format.short(value, 2));
  return menuButton({
    id,
    name: 'gauge',
    label: t('transport.speed'),
    text: times(speed),
    keys: '- +',
    keyText: '- +',
    items: SPEED_STEPS.map((value) => ({
      label: times(value),
      checked: value === speed,
      onChoose: () => onSpeed(value),
    })),
  });
}

export interface LoopProps {
  readonly words: Words;
  readonly looping: boolean;
  /** Seconds of the range A–B; null: all of it. */
  readonly rangeS: readonly [from: number, to: number] | null;
  readonly onLoop: () => void;
  readonly onLoopClear: () => void;
}

export function loopControl(props: LoopProps): TemplateResult {
  const { words, looping, rangeS, onLoop, onLoopClear } = props;
  const { t, format } = words;
  const range = rangeS?.map((timeS) => format.decimal(timeS, 2));
  return html`<button
      type="button"
      class="button ghost loop ${looping ? 'on' : ''}"
      aria-pressed=${String(looping)}
      aria-keyshortcuts="L"
      data-tip=${t('transport.loop.tip')}
      data-key="L"
      @click=${onLoop}
    >
      ${icon('repeat', 15)}<span>${t(range ? 'transport.ab' : 'transport.loop')}</span>
      ${range ? html`<span class="loop-range">${t('transport.range', ...range)}</span>` : nothing}
    </button>
    ${
      range
        ? iconButton({
            name: 'x',
            label: t('transport.loop.clear'),
            size: 14,
            small: true,
            keys: 'Shift+L',
            keyText: `${t('key.shift')} L`,
            onPress: onLoopClear,
          })
        : nothing
    }`;
}

export interface ZoomProps {
  readonly words: Words;
  /** The ways in which the zoom can still go. */
  readonly zooms: Readonly<Record<Zoom, boolean>>;
  /** What showing all is called. */
  readonly all: string;
  readonly onZoom: (way: Zoom) => void;
}

export function zoomButtons({ words: { t }, zooms, all, onZoom }: ZoomProps): TemplateResult {
  const button = (way: Zoom, values: Omit<IconButton, 'disabled' | 'onPress'>): TemplateResult =>
    iconButton({ ...values, disabled: !zooms[way], onPress: () => onZoom(way) });
  return html`
    ${button('out', { name: 'zoom-out', label: t('transport.zoom-out'), keys: 'Shift+Z', keyText: `${t('key.shift')} Z` })}
    ${button('in', { name: 'zoom-in', label: t('transport.zoom-in'), keys: 'Z', keyText: 'Z' })}
    ${button('all', { name: 'unfold-horizontal', label: all, keys: '0', keyText: '0' })}
  `;
}
