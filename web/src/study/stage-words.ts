/** The open clip and what is wrong with the stage in; why there is no figure out. */
import type { Context } from '../app/context';
import type { Trouble } from './load-stage';
import type { UnreadableClip } from './stage-overlay';

/** A sentence in the middle of the stage; empty while there is a figure. */
export function stageSentence({ store, language }: Context, trouble: Trouble): string {
  const { t } = language.words.value;
  const clip = store.openClip.value;
  if (!clip) return store.loading.value ? '' : t('stage.choose');
  if (clip.status === 'failed') return '';
  if (!clip.result) return t('stage.loading', clip.source.name);
  return trouble === null ? '' : t(troubleSentences[trouble]);
}

export const troubleSentences = {
  off: 'stage.off',
  'no-webgl2': 'stage.unavailable',
  'context-lost': 'stage.lost',
  'not-loaded': 'stage.not-loaded',
  'too-large': 'stage.too-large',
} as const;

/** A clip that could not be read: where in the file, and why. */
export function unreadable({ store, language }: Context): UnreadableClip | null {
  const clip = store.openClip.value;
  if (clip?.status !== 'failed' || !clip.failure) return null;
  const words = language.words.value;
  return {
    name: clip.source.name,
    place: placeInFile(words.t, clip.failure.line, clip.failure.column),
    reason: words.failure(clip.failure),
  };
}

type Translate = Context['language']['words']['value']['t'];

function placeInFile(t: Translate, line: number | null, column: number | null): string {
  if (line === null) return '';
  if (column === null) return t('place.line', String(line));
  return t('place.column', String(line), String(column));
}
