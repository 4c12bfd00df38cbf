/** A stage of the pair page and the state in; what is written over it out. */
import type { Context } from '../app/context';
import type { Words } from '../app/i18n/catalogue';
import { posture } from '../app/posture';
import { captionOf, type Caption } from '../study/caption';
import type { Trouble } from '../study/load-stage';
import { troubleSentences } from '../study/stage-words';
import { selectedIds, shortName, type PairClip } from './pair-clips';
import type { PairState } from './pair-state';
import type { PlateProps, StageOverlayProps } from './stage-overlay';

type StageText = Omit<StageOverlayProps, 'onLoadAgain' | 'onView'>;

export function stageWords(
  index: 0 | 1,
  context: Context,
  state: PairState,
  trouble: Trouble,
  chosen: number | null,
): StageText {
  const { store, language } = context;
  const superposed = store.compare.superposed.value;
  const clips = state.clips.value;
  const shown = clips.filter((_, place) => (superposed ? index === 0 : place === index));
  const drawing = shown.length > 0 && (trouble === null || trouble === 'too-large');
  return {
    words: language.words.value,
    plates: shown.map((clip) => plate(context, clip)),
    caption: chosen === null ? null : captionAt(context, state, chosen, shown.length > 1),
    view: drawing && index === 0 ? store.view.value : undefined,
    sentence: sentence(index, context, state, trouble),
  };
}

function plate({ store, language }: Context, clip: PairClip): PlateProps {
  const { t, format } = language.words.value;
  const lengthS = (clip.frames - 1) * clip.frameTimeS;
  const about = [
    store.labels.value.get(clip.id) ?? '',
    t('unit.seconds', format.decimal(lengthS, 2)),
  ];
  return {
    letter: clip.letter,
    place: clip.place,
    name: clip.name,
    qualifier: clip.qualifier,
    about: about.filter((text) => text !== '').join(' · '),
  };
}

/** What a clip shows at its moment, with its letter where there are others. */
export function captionAt(
  { language }: Context,
  state: PairState,
  place: number,
  named = false,
): Caption | null {
  const clip = state.clips.value[place];
  if (!clip) return null;
  const frame = state.moment.value.frames[place] ?? 0;
  return captionOfClip(
    language.words.value,
    clip,
    frame,
    state.currentKeyposes.value[place] ?? null,
    named,
  );
}

export function captionOfClip(
  words: Words,
  clip: PairClip,
  frame: number,
  current: number | null,
  named = false,
): Caption {
  const postures = clip.performer.keyposes?.postures ?? [];
  return captionOf(words, {
    frame,
    frameTimeS: clip.frameTimeS,
    keyposes: clip.keyposes,
    current,
    leadingRestFrames: clip.performer.leadingRestFrames,
    posture: current === null ? '' : posture(words, postures[current] ?? []),
    performer: named ? clip.letter : null,
  });
}

/** Why there is no figure. */
function sentence(index: 0 | 1, context: Context, state: PairState, trouble: Trouble): string {
  const { store, language } = context;
  const { t } = language.words.value;
  const id = selectedIds(store)[index];
  const clip = id === undefined ? null : store.clips.value[id];
  if (!clip) return index === 1 || state.clips.value.length === 0 ? t('pair.empty') : '';
  if (clip.status === 'failed') return t('pair.failed', shortName(clip.source.name));
  if (!clip.result) return t('pair.reading', shortName(clip.source.name));
  return trouble === null ? '' : t(troubleSentences[trouble]);
}
