/** Features as those of motions lie: a number of clips goes in, features in heaps of different width come out. */
import type { ClipFeature } from '../../web/src/engine/comparison-types';

const WIDTH = 12;
const JOINTS = 16;
const HEAPS = 60;

/** Numbers as if drawn, from 0 up to 1; always the same (Park and Miller 1988). */
function* drawn(): Generator<number, never> {
  let state = 5;
  for (;;) {
    state = (state * 16807) % 2147483647;
    yield state / 2147483647;
  }
}

export interface HeapedFeature {
  readonly heap: number;
  readonly feature: ClipFeature;
}

export function heapedFeatures(count: number): HeapedFeature[] {
  const draw = drawn();
  const next = (): number => draw.next().value;
  const heaps = Array.from({ length: HEAPS }, () => ({
    middle: Float64Array.from({ length: WIDTH }, () => 0.05 * next()),
    width: 0.024 * next(),
  }));
  return Array.from({ length: count }, () => {
    const heap = Math.floor(next() * HEAPS);
    const { middle, width } = heaps[heap];
    return { heap, feature: featureOf(middle.map((at) => at + width * (next() + next() - 1))) };
  });
}

/** Every joint adds as much. */
function featureOf(vector: Float64Array): ClipFeature {
  const byJoint = Float64Array.from(
    { length: JOINTS * WIDTH },
    (_, k) => vector[k % WIDTH] / JOINTS,
  );
  return {
    performer: 0,
    recorded: vector,
    acrossRigs: vector.slice(),
    recordedByJoint: byJoint,
    acrossRigsByJoint: byJoint.slice(),
  };
}
