/** What stands over the stage: views, what is shown with the figure, the keypose in words, the size of the grid; or why there is no figure. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import type { ViewPreset } from '../app/store';
import { iconButton } from '../common/buttons';
import { icon, type IconName } from '../common/icons';
import { menuButton } from '../common/menu';
import type { Caption } from './caption';

export interface UnreadableClip {
  readonly name: string;
  readonly place: string;
  readonly reason: string;
}

/** What can be shown with the figure, or not. */
export type Shown = 'follow' | 'ghosts' | 'trails';

export interface TrailJoint {
  readonly joint: number;
  readonly name: string;
  readonly drawn: boolean;
}

export interface StageOverlayProps {
  readonly words: Words;
  /** null: nothing is open or the clip is not ready. */
  readonly caption: Caption | null;
  readonly metric: boolean;
  /** Whether a figure is drawn. */
  readonly drawing: boolean;
  /** A sentence in the middle; empty for none. */
  readonly sentence: string;
  /** Given where that helps. */
  readonly onLoadAgain: (() => void) | null;
  readonly failure: UnreadableClip | null;
  readonly view: ViewPreset | null;
  readonly shown: Readonly<Record<Shown, boolean>>;
  readonly trailJoints: readonly TrailJoint[];
  readonly trailsAsFound: boolean;
  readonly fullScreen: boolean;
  readonly onView: (view: ViewPreset) => void;
  readonly onTurn: () => void;
  readonly onShow: (what: Shown) => void;
  readonly onTrailJoint: (joint: number) => void;
  readonly onTrailReset: () => void;
  readonly onFullScreen: () => void;
}

const presets: readonly ViewPreset[] = ['front', 'side', 'top'];

const shownIcons: Readonly<Record<Shown, IconName>> = {
  follow: 'focus',
  ghosts: 'ghost',
  trails: 'spline',
};

function views({ words: { t }, view, onView, onTurn }: StageOverlayProps): TemplateResult {
  const preset = (name: ViewPreset): TemplateResult =>
    html`<button
      type="button"
      class="tool ${name === view ? 'on' : ''}"
      aria-pressed=${String(name === view)}
      @click=${() => onView(name)}
    >
      ${t(`stage.${name}`)}
    </button>`;
  return html`<div class="tools" role="group" aria-label=${t('stage.views')}>
    ${presets.map(preset)}
    ${iconButton({ name: 'turn', label: t('stage.turn'), small: true, onPress: onTurn })}
  </div>`;
}

function shownTools(props: StageOverlayProps): TemplateResult {
  const { words, shown, onShow } = props;
  const { t } = words;
  const toggle = (what: Shown): TemplateResult =>
    html`<button
      type="button"
      class="tool ${shown[what] ? 'on' : ''}"
      aria-label=${t(`stage.${what}`)}
      aria-pressed=${String(shown[what])}
      @click=${() => onShow(what)}
    >
      ${icon(shownIcons[what], 14)}<span class="tool-name">${t(`stage.${what}`)}</span>
    </button>`;
  return html`<div class="tools" role="group" aria-label=${t('stage.shown')}>
    ${toggle('follow')}${toggle('ghosts')}${toggle('trails')}${trailMenu(props)}
  </div>`;
}

/** The keyboard's way to what a press on the figure does. */
function trailMenu(props: StageOverlayProps): TemplateResult {
  const { t } = props.words;
  const joints = props.trailJoints.map(({ joint, name, drawn }) => ({
    label: name,
    checked: drawn,
    several: true,
    onChoose: () => props.onTrailJoint(joint),
  }));
  const reset = { label: t('stage.trails.reset'), apart: true, onChoose: props.onTrailReset };
  return menuButton({
    id: 'trail-joints',
    name: 'chevron-down',
    label: t('stage.trails.joints'),
    items: props.trailsAsFound ? joints : [...joints, reset],
  });
}

function fullScreenTool({ words: { t }, fullScreen, onFullScreen }: StageOverlayProps) {
  return html`<div class="tools">
    ${iconButton({
      name: fullScreen ? 'minimize' : 'maximize',
      label: t(fullScreen ? 'stage.full-screen.leave' : 'stage.full-screen'),
      small: true,
      keys: 'F',
      keyText: 'F',
      onPress: onFullScreen,
    })}
  </div>`;
}

function failureCard(
  { words: { t } }: StageOverlayProps,
  { name, place, reason }: UnreadableClip,
): TemplateResult {
  return html`<div class="stage-failure" role="alert">
    ${icon('octagon-x', 20)}
    <div>
      <h2>${t('stage.failed')}</h2>
      <p class="failure-name">${name}${place ? ` · ${place}` : ''}</p>
      <p>${reason}</p>
    </div>
  </div>`;
}

function sentence({ words: { t }, sentence: text, onLoadAgain }: StageOverlayProps) {
  if (text === '') return nothing;
  const again = onLoadAgain
    ? html`<button type="button" class="button line" @click=${onLoadAgain}>
        ${t('stage.load-again')}
      </button>`
    : nothing;
  return html`<div class="stage-sentence">
    <p>${text}</p>
    ${again}
  </div>`;
}

function words({ caption, drawing, metric, words: { t } }: StageOverlayProps) {
  if (!caption) return nothing;
  const grid = html`<p class="stage-grid">
    ${t(metric ? 'stage.grid.metric' : 'stage.grid.body')}
  </p>`;
  return html`
    <p class="stage-caption">
      <strong>${caption.title}</strong> <span>${caption.posture}</span>
      <span class="stage-remark">${caption.remark}</span>
    </p>
    ${drawing ? grid : nothing}
  `;
}

export function stageOverlay(props: StageOverlayProps): TemplateResult {
  const { caption, drawing, failure } = props;
  return html`
    ${caption && drawing ? html`<div class="tools-left">${views(props)}</div>` : nothing}
    ${
      caption
        ? html`<div class="tools-right">
            ${drawing ? shownTools(props) : nothing}${fullScreenTool(props)}
          </div>`
        : nothing
    }
    ${failure ? failureCard(props, failure) : nothing} ${sentence(props)} ${words(props)}
  `;
}
