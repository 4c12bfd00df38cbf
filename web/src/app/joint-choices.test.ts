import { expect, test } from 'vitest';
import type { ClipResult, JointDecision, Skeleton } from '../engine/types';
import { copiesOf, inheritedJoints, skeletonKey, withJoint } from './joint-choices';
import { testClip } from './test-clips';

const skeleton = (...labels: string[]): Skeleton => ({
  labels,
  parents: Int32Array.from(labels, (_, index) => index - 1),
  endSites: new Uint8Array(labels.length),
});

const clipOf = (id: number, skeletons: Skeleton[], joints?: JointDecision[]) =>
  testClip(id, `${id}.bvh`, {
    result: { performers: skeletons.map((one) => ({ skeleton: one })) } as unknown as ClipResult,
    decisions: joints ? { joints } : {},
  });

const neck = (joint: number, performer = 0): JointDecision => ({ performer, role: 'neck', joint });

test('a joint replaces the one before, and can be taken back', () => {
  expect(withJoint([], 0, 'neck', 4)).toEqual([neck(4)]);
  expect(withJoint([neck(4), neck(4, 1)], 0, 'neck', 5)).toEqual([neck(4, 1), neck(5)]);
  expect(withJoint([neck(4)], 0, 'neck', null)).toEqual([]);
});

test('hierarchies are told apart by names and by parents', () => {
  const tree = { ...skeleton('a', 'b', 'c'), parents: Int32Array.of(-1, 0, 0) };
  expect(skeletonKey(skeleton('a', 'b', 'c'))).toBe(skeletonKey(skeleton('a', 'b', 'c')));
  expect(skeletonKey(skeleton('a', 'b', 'c'))).not.toBe(skeletonKey(tree));
  expect(skeletonKey(skeleton('a', 'b'))).not.toBe(skeletonKey(skeleton('a', 'c')));
});

test('copies go to the other clips of the hierarchy, to each performer of it', () => {
  const one = () => skeleton('a', 'b');
  const open = clipOf(0, [one()], [neck(1)]);
  const clips = [
    open,
    clipOf(1, [one()]),
    clipOf(2, [skeleton('x')]),
    clipOf(3, [skeleton('x'), one(), one()], [neck(0, 0), neck(0, 1)]),
    clipOf(4, [one()], [neck(1)]),
  ];
  const copies = copiesOf(clips, open, 0);
  expect(copies.clips).toBe(3);
  expect(copies.changes).toEqual([
    { id: 1, joints: [neck(1)] },
    { id: 3, joints: [neck(0, 0), neck(1, 1), neck(1, 2)] },
  ]);
});

test('a clip that is not read yet is left alone', () => {
  const open = clipOf(0, [skeleton('a')], [neck(0)]);
  expect(copiesOf([open, testClip(1, 'b.bvh')], open, 0)).toEqual({ clips: 0, changes: [] });
});

test('a clip that comes later takes over what its hierarchy agrees on', () => {
  const one = () => skeleton('a', 'b');
  const coming = clipOf(9, [one()]).result as ClipResult;
  const corrected = clipOf(0, [one()], [neck(1)]);
  expect(inheritedJoints([corrected, clipOf(1, [skeleton('x')])], coming)).toEqual([neck(1)]);
  expect(inheritedJoints([corrected, clipOf(1, [one()])], coming)).toBeNull();
  expect(inheritedJoints([corrected, clipOf(1, [one()], [neck(0)])], coming)).toBeNull();
  expect(inheritedJoints([clipOf(0, [one()])], coming)).toBeNull();
  expect(inheritedJoints([{ ...corrected, removed: true }], coming)).toBeNull();
});
