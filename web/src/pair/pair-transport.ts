/** The one time of the pair in; what moves it, and the times of A and B, out. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { iconButton, type IconButton } from '../common/buttons';
import { icon } from '../common/icons';
import { menuButton } from '../common/menu';
import { SPEED_STEPS } from '../player/clock';
import type { PairMoment } from './pair-clock';

export interface PairTransportProps {
  readonly words: Words;
  readonly moment: PairMoment;
  /** Of A and B. */
  readonly timesS: readonly [number, number];
  readonly atStart: boolean;
  readonly atEnd: boolean;
  readonly hasEarlierKeypose: boolean;
  readonly hasLaterKeypose: boolean;
  readonly onPlay: () => void;
  readonly onStep: (direction: 1 | -1) => void;
  readonly onKeypose: (direction: 1 | -1) => void;
  readonly onSpeed: (speed: number) => void;
  readonly onLoop: () => void;
  readonly onLoopClear: () => void;
}

function movers(props: PairTransportProps): TemplateResult {
  const { words, moment, atStart, atEnd } = props;
  const { t } = words;
  const button = (values: IconButton): TemplateResult => iconButton(values);
  const play = t(moment.playing ? 'transport.pause' : 'transport.play');
  return html`
    ${button({ name: 'previous-keypose', size: 18, label: t('transport.previous-keypose'), keys: 'Shift+K', keyText: `${t('key.shift')} K`, disabled: !props.hasEarlierKeypose, onPress: () => props.onKeypose(-1) })}
    ${button({ name: 'step-back', size: 15, label: t('transport.back'), keys: 'ArrowLeft', keyText: '←', disabled: atStart, onPress: () => props.onStep(-1) })}
    <button
      type="button"
      class="play-button"
      aria-label=${play}
      data-tip=${play}
      data-key=${t('help.space')}
      aria-keyshortcuts="Space"
      @click=${props.onPlay}
    >
      ${icon(moment.playing ? 'pause' : 'play', 15)}
    </button>
    ${button({ name: 'step-forward', size: 15, label: t('transport.on'), keys: 'ArrowRight', keyText: '→', disabled: atEnd, onPress: () => props.onStep(1) })}
    ${button({ name: 'next-keypose', size: 18, label: t('transport.next-keypose'), keys: 'K', keyText: 'K', disabled: !props.hasLaterKeypose, onPress: () => props.onKeypose(1) })}
  `;
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

function speedMenu({ words: { t, format }, moment, onSpeed }: PairTransportProps): TemplateResult {
  const name = (speed: number): string => t('transport.times', format.short(speed, 2));
  return menuButton({
    id: 'pair-speed-menu',
    name: 'gauge',
    label: t('transport.speed'),
    text: name(moment.speed),
    keys: '- +',
    keyText: '- +',
    items: SPEED_STEPS.map((speed) => ({
      label: name(speed),
      checked: speed === moment.speed,
      onChoose: () => onSpeed(speed),
    })),
  });
}

function loopButton({ words: { t, format }, moment, onLoop, onLoopClear }: PairTransportProps) {
  const { looping, loop } = moment;
  const range = loop
    ? t('transport.range', format.decimal(loop.fromS, 2), format.decimal(loop.toS, 2))
    : '';
  return html`<button
      type="button"
      class="button ghost loop ${looping ? 'on' : ''}"
      aria-pressed=${String(looping)}
      aria-keyshortcuts="L"
      data-tip=${t('transport.loop.tip')}
      data-key="L"
      @click=${onLoop}
    >
      ${icon('repeat', 15)}<span>${t(loop ? 'transport.ab' : 'transport.loop')}</span>
      ${range === '' ? nothing : html`<span class="loop-range">${range}</span>`}
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
            onPress: onLoopClear,
          })
        : nothing
    }`;
}

export function pairTransport(props: PairTransportProps): TemplateResult {
  const { t } = props.words;
  return html`
    <div class="movers">${movers(props)}</div>
    ${times(props)}
    <span class="rule"></span>
    <div class="transport-play">${speedMenu(props)} ${loopButton(props)}</div>
    <div class="transport-view pair-legend">
      <span>${t('pair.difference')}</span><span class="pair-legend-bar"></span>
    </div>
  `;
}
