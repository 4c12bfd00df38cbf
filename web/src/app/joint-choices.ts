/** Skeletons and what a person said of their joints in; the same for one more joint, or for other clips, out. */
import type { ClipResult, JointDecision, Skeleton } from '../engine/types';
import type { Clip } from './clips';
import type { JointsChange } from './decisions';

export type JointRole = JointDecision['role'];

const keys = new WeakMap<Skeleton, string>();
/** One string of each, so that comparing two is quick. */
const strings = new Map<string, string>();

/** The same for the same hierarchy. */
export function skeletonKey(skeleton: Skeleton): string {
  const known = keys.get(skeleton);
  if (known !== undefined) return known;
  const text = `${skeleton.parents.join()}\n${skeleton.labels.join('\n')}`;
  const key = strings.get(text) ?? text;
  strings.set(text, key);
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

/**
 * What a clip that has just been read takes over: the joints of the clips of its hierarchy, where a person
 * corrected them and they all agree; null if there is nothing to take over.
 */
export function inheritedJoints(
  clips: readonly Clip[],
  result: ClipResult,
): readonly JointDecision[] | null {
  const [performer] = result.performers;
  const corrected = clips.some(({ decisions }) => decisions.joints !== undefined);
  if (!performer || !corrected || result.performers.length > 1) return null;
  const key = skeletonKey(performer.skeleton);
  const alike = clips.filter(({ removed, result: other }) => {
    const one = other?.performers.length === 1 ? other.performers[0] : undefined;
    return !removed && one !== undefined && skeletonKey(one.skeleton) === key;
  });
  const joints = alike[0]?.decisions.joints;
  if (!joints || joints.length === 0) return null;
  return alike.every(({ decisions }) => sameJoints(decisions.joints ?? [], joints)) ? joints : null;
}
