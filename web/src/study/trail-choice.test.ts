import { expect, test } from 'vitest';
import { addClips, patchClip } from '../app/clip-changes';
import { createStore } from '../app/store';
import type { ClipResult } from '../engine/types';
import { createTrailChoice } from './trail-choice';

function choiceWith(...trailJoints: number[]) {
  const store = createStore();
  const performer = { trailJoints: Int32Array.from(trailJoints), keyposes: null };
  const result = { frames: 1, performers: [performer, performer] } as unknown as ClipResult;
  for (const name of ['a', 'b']) {
    const [clip] = addClips(store, [{ name, folder: '', blob: new Blob() }]);
    patchClip(store, clip.id, { result });
  }
  store.openId.value = 0;
  return { store, choice: createTrailChoice(store) };
}

test('at first the joints that were found, then those of the person', () => {
  const { choice } = choiceWith(9, 20);
  expect([choice.joints.value, choice.asFound.value]).toEqual([[9, 20], true]);
  choice.toggle(4);
  choice.toggle(9);
  expect([choice.joints.value, choice.asFound.value]).toEqual([[20, 4], false]);
  choice.reset();
  expect([choice.joints.value, choice.asFound.value]).toEqual([[9, 20], true]);
});

test('every performer of every clip has its own', () => {
  const { store, choice } = choiceWith(9);
  choice.toggle(4);
  store.performer.value = 1;
  expect(choice.joints.value).toEqual([9]);
  store.performer.value = 0;
  store.openId.value = 1;
  expect(choice.joints.value).toEqual([9]);
  store.openId.value = 0;
  expect(choice.joints.value).toEqual([9, 4]);
});

test('a joint that is asked for is seen, even if no trails were', () => {
  const { store, choice } = choiceWith(9);
  store.trails.value = false;
  choice.toggle(9);
  expect([choice.joints.value, store.trails.value]).toEqual([[9], true]);
  store.trails.value = false;
  choice.toggle(4);
  expect([choice.joints.value, store.trails.value]).toEqual([[9, 4], true]);
});
