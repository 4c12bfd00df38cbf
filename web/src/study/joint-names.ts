/** Joints of a performer in; what they are called on the page out, and which of them a menu offers. */
import type { Words } from '../app/i18n/catalogue';
import type { PerformerResult, Role } from '../engine/types';

type BodyOf = Pick<PerformerResult, 'body' | 'skeleton'>;

/** The part of the body, or the name in the file. */
export function jointName({ t }: Words, { body, skeleton }: BodyOf, joint: number): string {
  if (body.kind === 'human') {
    const part = body.joints.find((other) => other.joint === joint);
    if (part) return t(`role.${part.role}`);
    if (joint === body.pelvis) return t('role.pelvis');
  }
  return skeleton.labels[joint] ?? '';
}

/** What people follow first. */
const offeredRoles: readonly Role[] = [
  'left_wrist',
  'right_wrist',
  'left_ankle',
  'right_ankle',
  'left_elbow',
  'right_elbow',
  'left_knee',
  'right_knee',
  'head',
];
const mostOffered = 24;

/** Joints to choose from: those of the body's parts, or the ends of another body; and what is chosen already. */
export function offeredJoints({ body, skeleton }: BodyOf, chosen: readonly number[]): number[] {
  const usual = body.kind === 'human' ? partsOf(body) : endsOf(skeleton);
  const offered = [...usual, Math.max(0, body.pelvis)];
  return [...new Set([...offered, ...chosen])];
}

function partsOf({ joints }: PerformerResult['body']): number[] {
  return offeredRoles.flatMap((role) => joints.find((part) => part.role === role)?.joint ?? []);
}

/** The last joints of the chains; an End Site is its joint's end. */
function endsOf({ parents, endSites }: PerformerResult['skeleton']): number[] {
  const goesOn = new Set<number>();
  parents.forEach((parent, joint) => {
    if (!endSites[joint]) goesOn.add(parent);
  });
  const ends = [...parents.keys()].filter((joint) => !endSites[joint] && !goesOn.has(joint));
  return ends.slice(0, mostOffered);
}
