/** How far a film is in; the foot of the panel out: the button that begins it, or its progress and what ends it. */
import { html, nothing, svg, type TemplateResult } from 'lit-html';
import { Clapperboard } from 'lucide';
import type { Words } from '../app/i18n/catalogue';
import { estimateSecondsLeft, timeLeftText } from '../app/time-left';
import { icon } from '../common/icons';

export interface FilmUnderWay {
  /** Frames. */
  readonly done: number;
  readonly count: number;
  readonly elapsedS: number;
}

export interface FilmButtonProps {
  readonly words: Words;
  readonly underWay: FilmUnderWay | null;
  readonly expanded: boolean;
  /** The browser makes films. */
  readonly able: boolean;
  /** Id of the popover that it opens. */
  readonly opens: string;
  readonly onCancel: () => void;
}

/** Drawn here: the page's sheet of symbols comes before anybody asks for a film. */
function clapperboard(): TemplateResult {
  const shapes = Clapperboard.map(([, { d }]) => svg`<path d=${String(d)} />`);
  return html`<svg class="icon" width="14" height="14" viewBox="0 0 24 24" aria-hidden="true">
    ${shapes}
  </svg>`;
}

function progress(words: Words, film: FilmUnderWay): TemplateResult {
  const { t, format } = words;
  const { done, count, elapsedS } = film;
  return html`<div class="film-progress">
    <progress class="bar" max=${count} .value=${done} aria-label=${t('film.title')}></progress>
    <span class="film-count"
      >${t('film.progress', format.integer(done), format.integer(count))}</span
    >
    <span>${timeLeftText(words, estimateSecondsLeft(elapsedS, done, count))}</span>
  </div>`;
}

export function filmButton(props: FilmButtonProps): TemplateResult {
  const { words, underWay, expanded, able, opens, onCancel } = props;
  const { t } = words;
  return html`${underWay ? progress(words, underWay) : nothing}
    <button
      id="film-button"
      type="button"
      class="button line"
      popovertarget=${underWay ? nothing : opens}
      aria-haspopup=${underWay ? nothing : 'dialog'}
      aria-expanded=${underWay ? nothing : String(expanded)}
      aria-describedby=${able ? nothing : 'film-reason'}
      ?disabled=${!able}
      @click=${underWay ? onCancel : null}
    >
      ${underWay ? icon('x', 14) : clapperboard()}<span
        >${underWay ? t('film.stop') : t('film')}</span
      >
    </button>
    ${able ? nothing : html`<p id="film-reason" class="film-reason">${t('film.no-encoder')}</p>`}`;
}
