/** Skeletons and what a person said of their joints in; the same for one more joint, or for other clips, out. */
import type { Clip } from '../app/clips';
import type { JointsChange } from '../app/decisions';
import type { JointDecision, Skeleton } from '../engine/types';

export type JointRole = JointDecision['role'];

const keys = new WeakMap<Skeleton, string>();

/** The same for the same hierarchy. */
export function skeletonKey(skeleton: Skeleton): string {
  const known = keys.get(skeleton);
  if (known !== undefined) return known;
  const key = `${skeleton.parents.join()}\n${skeleton.labels.join('\n')}`;
  keys.set(skeleton, key);
  return key;
}

/** `joint` for a role of a performer; null: as found. */
export function withJoint(
  decided: readonly JointDecision[],
  performer: number,
  role: JointRole,
  joint: number | null,
): readonly JointDecision[] {
  const others = decided.filter((one) => one.performer !== performer || one.role !== role);
  return joint === null ? others : [...others, { performer, role, joint }];
}

const sameJoints = (a: readonly JointDecision[], b: readonly JointDecision[]): boolean => {
  const texts = (all: readonly JointDecision[]): string =>
    all
      .map(({ performer, role, joint }) => `${performer} ${role} ${joint}`)
      .sort()
      .join();
  return texts(a) === texts(b);
};

/** What a performer's joints mean for a clip: the same for every performer of that skeleton in it. */
function changeFor(
  clip: Clip,
  key: string,
  decided: readonly JointDecision[],
): JointsChange | null {
  const performers = clip.result?.performers ?? [];
  const alike = performers.flatMap(({ skeleton }, index) =>
    skeletonKey(skeleton) === key ? [index] : [],
  );
  if (alike.length === 0) return null;
  const others = (clip.decisions.joints ?? []).filter(
    ({ performer }) => !alike.includes(performer),
  );
  const copies = alike.flatMap((performer) => decided.map((one) => ({ ...one, performer })));
  return { id: clip.id, joints: [...others, ...copies] };
}

export interface JointCopies {
  /** Other clips of the skeleton. */
  readonly clips: number;
  /** Of those, the ones that are to be changed. */
  readonly changes: readonly JointsChange[];
}

/** What a person said of one performer's joints, for all other clips of that hierarchy. */
export function copiesOf(clips: readonly Clip[], open: Clip, performer: number): JointCopies {
  const skeleton = open.result?.performers[performer]?.skeleton;
  if (!skeleton) return { clips: 0, changes: [] };
  const decided = (open.decisions.joints ?? []).filter((one) => one.performer === performer);
  const others = clips.filter(({ id }) => id !== open.id);
  const alike = others.flatMap((clip) => {
    const change = changeFor(clip, skeletonKey(skeleton), decided);
    return change ? [{ change, clip }] : [];
  });
  const changed = alike.filter(
    ({ change, clip }) => !sameJoints(change.joints, clip.decisions.joints ?? []),
  );
  return { clips: alike.length, changes: changed.map(({ change }) => change) };
}
