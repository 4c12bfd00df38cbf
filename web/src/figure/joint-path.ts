/** In: parents of joints, two joints of one chain. Out: the joints between them, and points on that path. */
import { type ConePoint, jointDistance } from './bone-cone';

/** Joints from `ancestor` down to `joint`, both included; just the two where one is not above the other. */
export function jointPath(parents: ArrayLike<number>, ancestor: number, joint: number): number[] {
  const path = [joint];
  for (let at = joint; at !== ancestor;) {
    at = parents[at] ?? -1;
    if (at < 0) return [ancestor, joint];
    path.push(at);
  }
  return path.reverse();
}

/** The path without inner joints closer than `gap` to the one kept before or to the end. */
export function thinned(path: readonly number[], joints: ArrayLike<number>, gap: number): number[] {
  const last = path[path.length - 1];
  const kept = [path[0]];
  for (const joint of path.slice(1, -1)) {
    const fromBefore = jointDistance(joints, kept[kept.length - 1], joint);
    if (fromBefore >= gap && jointDistance(joints, joint, last) >= gap) kept.push(joint);
  }
  return [...kept, last];
}

/** Fractions 0 … 1 of the path's length at each of its joints; evenly spaced if it has no length. */
export function pathFractions(path: readonly number[], joints: ArrayLike<number>): number[] {
  const lengths = [0];
  for (let i = 1; i < path.length; i++) {
    lengths.push(lengths[i - 1] + jointDistance(joints, path[i - 1], path[i]));
  }
  const total = lengths[lengths.length - 1];
  return lengths.map((length, i) =>
    total > 0 ? length / total : i / Math.max(1, path.length - 1),
  );
}

/** The point at a fraction of the path's length, riding on the two joints around it. */
export function pointOnPath(
  path: readonly number[],
  fractions: readonly number[],
  fraction: number,
): ConePoint {
  let i = 1;
  while (i < path.length - 1 && fractions[i] < fraction) i++;
  const span = fractions[i] - fractions[i - 1];
  return {
    from: path[i - 1],
    to: path[i],
    mix: span > 0 ? (fraction - fractions[i - 1]) / span : 0,
  };
}
