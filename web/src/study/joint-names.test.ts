import { expect, test } from 'vitest';
import { wordsFor } from '../app/i18n/catalogue';
import { animal, human } from '../figure/test-bodies';
import { jointName, offeredJoints } from './joint-names';

const words = wordsFor('en');

test('a joint is called by the part of the body, or as in the file', () => {
  expect(jointName(words, human, 8)).toBe('Left wrist');
  expect(jointName(words, human, 0)).toBe('Pelvis');
  expect(jointName(words, human, 2)).toBe('Chest');
  expect(jointName(words, animal, 8)).toBe('LeftHand');
});

test('a menu offers wrists first, then what else moves, and what was chosen', () => {
  const offered = offeredJoints(human, [2, 8]).map((joint) => jointName(words, human, joint));
  expect(offered.slice(0, 4)).toEqual(['Left wrist', 'Right wrist', 'Left ankle', 'Right ankle']);
  expect(offered.slice(-3)).toEqual(['Head', 'Pelvis', 'Chest']);
});

test('of another body it offers the ends of the chains', () => {
  const offered = offeredJoints(animal, []).map((joint) => jointName(words, animal, joint));
  expect(offered).toEqual(['Head', 'LeftHand', 'RightHand', 'LeftToeBase', 'RightToeBase', 'Hips']);
});
