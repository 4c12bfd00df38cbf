/** A place at the foot of the pair's panel in; the button that makes a film of the pair, its choices, its progress, out. */
import '../styles/film.css';
import { computed, signal, type ReadonlySignal } from '@preact/signals-core';
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Context } from '../app/context';
import type { Words } from '../app/i18n/catalogue';
import { keptBeside } from '../common/beside';
import { mount } from '../common/mount';
import { hasEncoder } from '../film/film-codec';
import { filmShape } from '../film/film-shape';
import { filmTimes } from '../film/film-times';
import { filmButton } from './film-button';
import { createFilmMaker, type FilmMaker } from './film-maker';
import { filmPanel, filmPanelId } from './film-panel';
import { filmWish, stretchOf } from './film-wish';
import { loopTimes } from './loop-frames';
import type { PairStages } from './mount-stages';
import type { PairState } from './pair-state';

const usualShape = filmShape(720, 30);

const overButton = keptBeside({ opens: filmPanelId, side: 'above', edge: 'right' });
const close = (): void => document.getElementById(filmPanelId)?.hidePopover();

export function mountFilm(
  place: HTMLElement,
  context: Context,
  state: PairState,
  shown: PairStages,
): void {
  const open = signal(false);
  const maker = createFilmMaker(context, () => filmWish(context, state, shown));
  const choices = createChoices(state, waitsFor(context, state, shown), maker);
  const able = hasEncoder();
  const onToggle = (event: Event): void => {
    open.value = (event.currentTarget as HTMLElement).matches(':popover-open');
  };
  mount(place, () => {
    const words = context.language.words.value;
    const underWay = maker.underWay.value;
    place.hidden = state.clips.value.length < 2;
    const opens = filmPanelId;
    return html`${filmButton({ words, underWay, expanded: open.value, able, opens, onCancel: maker.cancel })}
      <div
        id=${filmPanelId}
        class="form-panel film-panel"
        popover
        role="dialog"
        aria-label=${words.t('film.title')}
        @beforetoggle=${overButton}
        @toggle=${onToggle}
      >
        ${open.value ? choices(words) : nothing}
      </div>`;
  });
}

/** The content of the panel, in words. */
function createChoices(
  state: PairState,
  waits: ReadonlySignal<boolean>,
  { make }: FilmMaker,
): (words: Words) => TemplateResult {
  const shape = signal(usualShape);
  return (words) => {
    const { count, lengthS } = filmTimes(stretchOf(state), shape.value.rate_hz);
    return filmPanel({
      words,
      shape: shape.value,
      about: aboutOf(words, state),
      lengthS,
      count,
      waits: waits.value ? words.t('film.waits') : '',
      onShape: (other) => {
        shape.value = other;
      },
      onSave: () => {
        close();
        void make(shape.peek());
      },
      onClose: close,
    });
  };
}

/** A path or places that are not known yet would make another film than the one asked for. */
function waitsFor(
  { store }: Context,
  { warpings }: PairState,
  { placements }: PairStages,
): ReadonlySignal<boolean> {
  const { superposed, synchronisation } = store.compare;
  return computed(
    () =>
      (synchronisation.value === 'warp' && warpings.underWay.value) ||
      (superposed.value && placements.value === null),
  );
}

/** "The whole pair · 0.5× speed". */
function aboutOf({ t, format }: Words, { moment, alignment }: PairState): string[] {
  const { loop, speed } = moment.value;
  const times = loop && loopTimes(loop, alignment.value).map((timeS) => format.decimal(timeS, 2));
  return [
    times ? t('film.loop', ...times) : t('film.all'),
    ...(speed === 1 ? [] : [t('film.speed', String(speed))]),
  ];
}
