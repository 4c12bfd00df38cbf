/** A clip's result in; what it is compared by, or why it cannot be compared, out. */
import type { ClipFeature } from '../engine/comparison-types';
import { incomparableOf } from '../engine/failures';
import type { ClipResult } from '../engine/types';
import type { Clip } from './clips';

const partsOf = ({
  recorded,
  acrossRigs,
  recordedByJoint,
  acrossRigsByJoint,
}: ClipFeature): readonly Float64Array[] => [
  recorded,
  acrossRigs,
  recordedByJoint,
  acrossRigsByJoint,
];

function isSame(a: ClipFeature, b: ClipFeature): boolean {
  const others = partsOf(b);
  const equal = (part: Float64Array, index: number): boolean =>
    part.every((value, at) => Object.is(value, others[index]?.[at]));
  return a.performer === b.performer && partsOf(a).every(equal);
}

/** The first performer that can be compared; the feature known before where it is the same. */
export function comparableOf(
  { performers }: ClipResult,
  before: ClipFeature | null,
): Pick<Clip, 'feature' | 'incomparable'> {
  const feature = performers.find(({ comparable }) => comparable)?.comparable ?? null;
  if (feature !== null) {
    return { feature: before && isSame(before, feature) ? before : feature, incomparable: null };
  }
  return { feature, incomparable: incomparableOf(performers) };
}
