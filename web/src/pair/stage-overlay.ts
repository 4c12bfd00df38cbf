/** Words and the view in; what stands over a stage of the pair page out. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import type { ViewPreset } from '../app/store';
import { clipName } from '../common/clip-name';
import type { Caption } from '../study/caption';
import { who } from './who';

export interface PlateProps {
  readonly letter: string;
  readonly place: number;
  readonly name: string;
  readonly qualifier: string;
  readonly about: string;
}

export interface StageOverlayProps {
  readonly words: Words;
  /** The clips on the stage. */
  readonly plates: readonly PlateProps[];
  readonly caption: Caption | null;
  /** Given where views can be chosen; null: the person turned the camera. */
  readonly view: ViewPreset | null | undefined;
  /** In the middle; may be empty. */
  readonly sentence: string;
  readonly onLoadAgain: (() => void) | null;
  readonly onView: (view: ViewPreset) => void;
}

/** Of more clips the stage shows no more than their names. */
const FEW = 4;

const presets: readonly ViewPreset[] = ['front', 'side', 'top'];

function views({ words: { t }, view, onView }: StageOverlayProps) {
  if (view === undefined) return nothing;
  return html`<div class="tools-right">
    <div class="tools" role="group" aria-label=${t('stage.views')}>
      ${presets.map(
        (name) =>
          html`<button
            type="button"
            class="tool ${name === view ? 'on' : ''}"
            aria-pressed=${String(name === view)}
            @click=${() => onView(name)}
          >
            ${t(`stage.${name}`)}
          </button>`,
      )}
    </div>
  </div>`;
}

const plate = ({ letter, place, name, qualifier, about }: PlateProps): TemplateResult =>
  html`<li class="pair-plate">
    ${who(letter, place)}<b>${clipName(name, qualifier)}</b
    ><span class="pair-plate-about">${about}</span>
  </li>`;

function caption({ caption: words }: StageOverlayProps) {
  if (!words) return nothing;
  return html`<p class="stage-caption">
    <strong>${words.title}</strong> <span title=${words.posture}>${words.posture}</span>
    <span class="stage-remark">${words.remark}</span>
  </p>`;
}

function sentence({ words: { t }, sentence: text, onLoadAgain }: StageOverlayProps) {
  if (text === '') return nothing;
  const again = html`<button type="button" class="button line" @click=${onLoadAgain}>
    ${t('stage.load-again')}
  </button>`;
  return html`<div class="stage-sentence">
    <p>${text}</p>
    ${onLoadAgain ? again : nothing}
  </div>`;
}

export function stageOverlay(props: StageOverlayProps): TemplateResult {
  return html`
    <ul class="pair-plates ${props.plates.length > FEW ? 'many' : ''}">
      ${props.plates.map(plate)}
    </ul>
    ${views(props)} ${sentence(props)} ${caption(props)}
  `;
}
