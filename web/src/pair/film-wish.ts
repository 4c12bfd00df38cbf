/** The pair page as it stands in; all that a film of it goes by out, so that the page may go on meanwhile. */
import type { Context } from '../app/context';
import type { Words } from '../app/i18n/catalogue';
import type { ViewPreset } from '../app/store';
import type { FilmStretch } from '../film/film-times';
import type { Placement } from '../figure/placement';
import type { Stance, Theme } from '../stage';
import type { Alignment } from './alignment';
import type { PairStages } from './mount-stages';
import type { PairClip } from './pair-clips';
import type { PairState } from './pair-state';

export interface FilmWish {
  readonly clips: readonly PairClip[];
  /** Of each clip; empty for none. */
  readonly labels: readonly string[];
  readonly alignment: Alignment;
  readonly stretch: FilmStretch;
  readonly superposed: boolean;
  readonly mirrorB: boolean;
  readonly placements: readonly Placement[] | null;
  /** Of each stage: the clip whose keyposes and trails are shown, and from where it is looked at. */
  readonly panes: readonly FilmWishPane[];
  readonly keyposes: boolean;
  readonly trails: boolean;
  readonly follow: boolean;
  readonly preset: ViewPreset;
  readonly theme: Theme;
  readonly words: Words;
}

interface FilmWishPane {
  readonly place: number;
  readonly stance: Stance | null;
}

/** A–B where it is set, else all; as fast as it plays. */
export function stretchOf({ moment, alignment }: PairState): FilmStretch {
  const { loop, speed } = moment.value;
  return { ...(loop ?? { fromS: 0, toS: alignment.value.durationS }), speed };
}

export function filmWish(context: Context, state: PairState, shown: PairStages): FilmWish {
  const { store, language, theme } = context;
  const { superposed, mirrorB } = store.compare;
  const clips = state.clips.peek();
  const seen = superposed.peek() ? shown.stages.slice(0, 1) : shown.stages;
  return {
    clips,
    labels: clips.map(({ id }) => store.labels.peek().get(id) ?? ''),
    alignment: state.alignment.peek(),
    stretch: stretchOf(state),
    superposed: superposed.peek(),
    mirrorB: mirrorB.peek(),
    placements: shown.placements.peek(),
    panes: seen.map((one, index) => ({
      place: one.shown.peek()?.place ?? index,
      stance: one.stage.peek()?.stance() ?? null,
    })),
    keyposes: store.ghosts.peek(),
    trails: store.trails.peek() && !superposed.peek(),
    follow: store.follow.peek(),
    preset: store.view.peek() ?? 'side',
    theme: theme.theme.peek(),
    words: language.words.peek(),
  };
}
