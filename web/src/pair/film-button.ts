/** How far a film is in; the foot of the panel out: the button that begins it, or its progress and what ends it. */
import { html, nothing, svg, type TemplateResult } from 'lit-html';
import { Clapperboard } from 'lucide';
import type { Words } from '../app/i18n/catalogue';
import { estimateSecondsLeft } from '../app/time-left';
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

function timeLeft({ t, format }: Words, { done, count, elapsedS }: FilmUnderWay): string {
  const leftS = estimateSecondsLeft(elapsedS, done, count);
  if (leftS === null) return '';
  return leftS < 90
    ? t('progress.left.seconds', format.integer(Math.max(1, Math.ceil(leftS))))
    : t('progress.left.minutes', format.integer(Math.ceil(leftS / 60)));
}

function progress(words: Words, film: FilmUnderWay): TemplateResult {
  const { t, format } = words;
  const { done, count } = film;
  return html`<div class="film-progress">
    <progress class="bar" max=${count} .value=${done} aria-label=${t('film.title')}></progress>
    <span class="film-count"
      >${t('film.progress', format.integer(done), format.integer(count))}</span
    >
    <span>${timeLeft(words, film)}</span>
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
