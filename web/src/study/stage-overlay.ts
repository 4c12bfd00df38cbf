/** What stands over the stage: views, follow, the keypose in words, the size of the grid; or why there is no figure. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import type { ViewPreset } from '../app/store';
import { icon } from '../common/icons';
import type { Caption } from './caption';

export interface StageFailure {
  readonly name: string;
  readonly place: string;
  readonly reason: string;
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
  readonly failure: StageFailure | null;
  readonly view: ViewPreset | null;
  readonly follow: boolean;
  readonly onView: (view: ViewPreset) => void;
  readonly onFollow: () => void;
}

const presets: readonly ViewPreset[] = ['front', 'side', 'top'];

function tools({
  words: { t },
  view,
  follow,
  onView,
  onFollow,
}: StageOverlayProps): TemplateResult {
  const preset = (name: ViewPreset): TemplateResult =>
    html`<button
      type="button"
      class="tool ${name === view ? 'on' : ''}"
      aria-pressed=${String(name === view)}
      @click=${() => onView(name)}
    >
      ${t(`stage.${name}`)}
    </button>`;
  return html`
    <div class="tools tools-left" role="group" aria-label=${t('stage.views')}>
      ${presets.map(preset)}
    </div>
    <div class="tools tools-right">
      <button
        type="button"
        class="tool ${follow ? 'on' : ''}"
        aria-pressed=${String(follow)}
        @click=${onFollow}
      >
        ${icon('focus', 14)}${t('stage.follow')}
      </button>
    </div>
  `;
}

function failureCard(
  { words: { t } }: StageOverlayProps,
  { name, place, reason }: StageFailure,
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

export function stageOverlay(props: StageOverlayProps): TemplateResult {
  const {
    words: { t },
    caption,
  } = props;
  return html`
    ${props.drawing && caption ? tools(props) : nothing}
    ${props.failure ? failureCard(props, props.failure) : nothing}
    ${props.sentence ? html`<p class="stage-sentence">${props.sentence}</p>` : nothing}
    ${
      caption
        ? html`<p class="stage-caption">
            <strong>${caption.title}</strong> <span>${caption.remark}</span>
          </p>`
        : nothing
    }
    ${
      props.drawing && caption
        ? html`<p class="stage-grid">
            ${t(props.metric ? 'stage.grid.metric' : 'stage.grid.body')}
          </p>`
        : nothing
    }
  `;
}
