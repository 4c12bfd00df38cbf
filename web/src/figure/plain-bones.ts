/** In: any skeleton. Out: one cone for each parent and child, for bodies that are not human. */
import type { Skeleton } from '../engine/types';
import { atJoint, type BoneCone } from './bone-cone';
import { RADII } from './radii';

/** Bones of one unbranched chain are one limb. */
export function plainBones(skeleton: Skeleton): BoneCone[] {
  const { parents } = skeleton;
  const limbs = chainNumbers(parents);
  const bones: BoneCone[] = [];
  for (let joint = 0; joint < parents.length; joint++) {
    const parent = parents[joint];
    if (parent < 0) continue;
    const [startRadius, endRadius] = RADII.other;
    bones.push({
      start: atJoint(parent),
      end: atJoint(joint),
      startRadius,
      endRadius,
      side: 'trunk',
      limb: limbs[joint],
    });
  }
  return bones;
}

/** A number for each joint, shared along a chain until it branches; parents come before children. */
function chainNumbers(parents: Int32Array): Int32Array {
  const children = new Int32Array(parents.length);
  for (const parent of parents) if (parent >= 0) children[parent]++;
  const numbers = new Int32Array(parents.length);
  let next = 0;
  parents.forEach((parent, joint) => {
    const continues = parent >= 0 && parents[parent] >= 0 && children[parent] === 1;
    numbers[joint] = continues ? numbers[parent] : next++;
  });
  return numbers;
}
