/** For tests: clips on a line, and a comparer whose workers live in this thread. */
import { createComparer } from './comparer';
import type { ComparisonApi } from './comparison-protocol';
import type { ComparisonCore } from './comparison-raw';
import type { ClipFeature, Comparer, ComparisonSettings } from './comparison-types';
import type { PoolWorker } from './pool-task';
import { spawnComparisonAround } from './test-engine';

export const ward: ComparisonSettings = {
  distance: { measure: 'posture-variation', mirrorAware: false, acrossRigs: false },
  linkage: 'ward',
};
export const average: ComparisonSettings = { ...ward, linkage: 'average' };

const nothing = { postures: () => Promise.reject(new Error('none')) };

/** A clip at a place on a line. */
export function at(place: number): ClipFeature {
  const vector = (length: number): Float64Array => {
    const numbers = new Float64Array(length);
    numbers[0] = place;
    return numbers;
  };
  return {
    performer: 0,
    recorded: vector(12),
    acrossRigs: vector(12),
    recordedByJoint: vector(192),
    acrossRigsByJoint: vector(192),
  };
}

export function withPlaces(comparer: Comparer, places: readonly number[]): Comparer {
  places.forEach((place, id) => comparer.setFeature(id, `clip ${id}`, at(place)));
  return comparer;
}

/** A comparer and the workers that it has started. */
export function comparerAround(core: ComparisonCore) {
  const spawn = spawnComparisonAround(core);
  const workers: PoolWorker<ComparisonApi>[] = [];
  const deaths: ((message: string) => void)[] = [];
  const comparer = createComparer(nothing, (listener, died) => {
    const worker = spawn(listener, died);
    workers.push(worker);
    deaths.push(died);
    return worker;
  });
  return { comparer, workers, deaths };
}
