/** What can be chosen about a film, what it shows and how long it is in; the panel over the button out. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { iconButton } from '../common/buttons';
import { icon } from '../common/icons';
import { filmHeights, filmRates_hz, type FilmShape, filmShape } from '../film/film-shape';
import { segments } from './segments';

export interface FilmPanelProps {
  readonly words: Words;
  readonly shape: FilmShape;
  /** What of the pair it shows: all or A–B, as fast as it plays. */
  readonly about: readonly string[];
  readonly lengthS: number;
  readonly count: number;
  /** Why it cannot be made yet; may be empty. */
  readonly waits: string;
  readonly onShape: (shape: FilmShape) => void;
  readonly onSave: () => void;
  readonly onClose: () => void;
}

export const filmPanelId = 'film-panel';

function choices({ words: { t, format }, shape, onShape }: FilmPanelProps): TemplateResult {
  const { height, rate_hz } = shape;
  const sizes = filmHeights.map((other) => ({
    label: `${filmShape(other, rate_hz).width} × ${other}`,
    chosen: other === height,
    onChoose: () => onShape(filmShape(other, rate_hz)),
  }));
  const rates = filmRates_hz.map((other) => ({
    label: format.integer(other),
    chosen: other === rate_hz,
    onChoose: () => onShape(filmShape(height, other)),
  }));
  return html`<span class="film-name" aria-hidden="true">${t('film.size')}</span>
    ${segments(t('film.size'), sizes)}
    <span class="film-name" aria-hidden="true">${t('film.rate')}</span>
    ${segments(t('film.rate'), rates)}`;
}

export function filmPanel(props: FilmPanelProps): TemplateResult {
  const { words, about, lengthS, count, waits, onSave, onClose } = props;
  const { t, format } = words;
  return html`<div class="dialog-head">
      <h2>${t('film.title')}</h2>
      ${iconButton({ name: 'x', label: t('help.close'), onPress: onClose })}
    </div>
    <div class="film-form">
      <div class="film-choices">${choices(props)}</div>
      <p class="film-facts">
        <b>${t('film.length', format.decimal(lengthS, 2), format.integer(count))}</b>
        <span>${about.join(' · ')}</span>
        <span>${t('film.about')}</span>
      </p>
      ${waits === '' ? nothing : html`<p class="film-waits">${icon('info', 14)}<span>${waits}</span></p>`}
      <div class="film-buttons">
        <button type="button" class="button line" @click=${onClose}>${t('film.cancel')}</button>
        <button type="button" class="button primary" ?disabled=${waits !== ''} @click=${onSave}>
          ${t('film.save')}
        </button>
      </div>
    </div>`;
}
