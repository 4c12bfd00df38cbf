/** The comparison and the pair in; the number between A and B, and its place, in words out. */
import type { Context } from '../app/context';
import { distanceNumber } from '../compare/distance-number';
import type { Explanation } from '../engine/comparison-types';

/** What is known of A and B; null while it is of another pair or not yet known. */
export function explanationOf({ store }: Context): Explanation | null {
  const { explanation, otherId } = store.compare;
  const found = explanation.value;
  const isTheirs = found?.a === store.openId.value && found.b === otherId.value;
  return isTheirs ? found : null;
}

export interface DistanceText {
  readonly number: string;
  /** "B is 11th of 38 from A". */
  readonly rank: string;
}

export function distanceText({ store, language }: Context, found: Explanation): DistanceText {
  const words = language.words.value;
  const others = Math.max(1, (store.compare.comparison.value?.clips.length ?? 2) - 1);
  const { rankFromA: rank } = found;
  const count = words.format.integer(others);
  return {
    number: distanceNumber(words.format, found.distance),
    rank:
      others === 1
        ? ''
        : rank === 1
          ? words.t('pair.rank.nearest', count)
          : words.t('pair.rank', words.format.ordinal(rank), count),
  };
}
