import { expect, test } from 'vitest';
import { labelInName, parsePattern, patternFault } from './label-pattern';

function label(pattern: string, name: string): string | null {
  const parsed = parsePattern(pattern);
  if (!parsed) throw new Error(`${pattern}: ${patternFault(pattern)}`);
  return labelInName(parsed, name);
}

test('the label is what stands in its place, as short as the rest allows', () => {
  expect(label('{label}_*', '05_08.bvh')).toBe('05');
  expect(label('{label}_*', 'slow_walk_3.bvh')).toBe('slow');
  expect(label('*_{label}', 'anna_slow_walk.bvh')).toBe('slow_walk');
  expect(label('*_{label}_*', 'anna_walk_tired_3.bvh')).toBe('walk');
  expect(label('{label}', 'walk.bvh')).toBe('walk');
  expect(label('{label}', '歩き.bvh')).toBe('歩き');
});

test('a name that does not match has no label, and no label is empty', () => {
  expect(label('{label}_*', 'walk.bvh')).toBe(null);
  expect(label('{label}_*', '_8.bvh')).toBe(null);
  expect(label('s{label}_*', '05_08.bvh')).toBe(null);
  expect(label('{label}_08', '05_09.bvh')).toBe(null);
  // The ends may not share signs.
  expect(label('ab{label}b', 'ab.bvh')).toBe(null);
  expect(label('ab-{label}', 'ab-.bvh')).toBe(null);
});

test('an empty label is passed over where a later place allows one', () => {
  expect(label('{label}_*', '__x.bvh')).toBe('_');
});

test('the ending belongs to no label unless the pattern names it', () => {
  expect(label('*_{label}', 'a_walk.BVH')).toBe('walk');
  expect(label('{label}_*.bvh', 'walk_1.bvh')).toBe('walk');
  expect(label('{label}.bvh', 'walk.BVH')).toBe(null);
  expect(label('*.{label}', 'take.3.bvh')).toBe('3');
});

test('upper and lower case differ', () => {
  expect(label('Take{label}', 'take3.bvh')).toBe(null);
});

test('several stars as one', () => {
  expect(label('**_{label}', 'a_b.bvh')).toBe('b');
});

test('what is wrong with a pattern', () => {
  expect(patternFault('*_walk')).toBe('no-label');
  expect(patternFault('')).toBe('no-label');
  expect(patternFault('{label}_{label}')).toBe('many-labels');
  expect(patternFault('{label}_{take}')).toBe('brace');
  expect(patternFault('{label')).toBe('brace');
  expect(patternFault('{label}*')).toBe('touching');
  expect(patternFault('*{label}_1')).toBe('touching');
  expect(patternFault('{label}_*')).toBe(null);
  expect(parsePattern('{take}')).toBe(null);
});
