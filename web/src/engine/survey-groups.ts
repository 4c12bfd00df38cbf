/**
 * Many clips in, groups of them that make one message each out; what a worker answers to a group in,
 * one survey a clip out.
 */
import { unpackFeature } from './comparison-protocol';
import type { SurveyGroup } from './protocol';
import type { ClipSurvey, Failure, SurveyItem } from './types';

/** A group is so small that progress is smooth and so large that messages cost nothing. */
const GROUP_BYTES = 4 * 2 ** 20;
const GROUP_CLIPS = 32;

export function surveyGroups(items: readonly SurveyItem[]): readonly SurveyItem[][] {
  const groups: SurveyItem[][] = [];
  let bytes = 0;
  for (const item of items) {
    const group = groups.at(-1);
    const { size } = item.source.blob;
    if (group && group.length < GROUP_CLIPS && bytes + size <= GROUP_BYTES) {
      group.push(item);
      bytes += size;
    } else {
      groups.push([item]);
      bytes = size;
    }
  }
  return groups;
}

export function surveysOf({ surveys, features }: SurveyGroup): readonly ClipSurvey[] {
  let index = 0;
  return surveys.map(({ performer, ...rest }) => ({
    ...rest,
    feature: performer === null ? null : unpackFeature(features, index++, performer),
  }));
}

/** The surveys of clips none of which could be read. */
export function failedSurveys(
  items: readonly SurveyItem[],
  failure: Failure,
): readonly ClipSurvey[] {
  return items.map(({ id }) => ({
    id,
    failure,
    frames: 0,
    frameTimeS: 0,
    feature: null,
    incomparable: null,
  }));
}
