import { expect, test } from 'vitest';
import { wordsFor, type Language } from '../app/i18n/catalogue';
import type { DistanceSentence, Explanation } from '../engine/comparison-types';
import { bodyParts, type BodyPart } from '../engine/types';
import { carriers, whyWords } from './why-words';

function explained(
  sentence: DistanceSentence,
  shares: readonly number[] = [0, 0, 0, 0, 0],
  mirrored = false,
): Explanation {
  const parts = Object.fromEntries(bodyParts.map((part, i) => [part, shares[i]]));
  const partShares = parts as Record<BodyPart, number>;
  return { sentence, partShares, mirrored } as Explanation;
}

function said(explanation: Explanation, language: Language = 'en'): string {
  const { text, marks } = whyWords(wordsFor(language), explanation);
  return text.replace(/[\ue000-\ue0ff]/g, (sign) => {
    const mark = marks[sign.charCodeAt(0) - 0xe000];
    if (mark.kind === 'clip') return mark.which.toUpperCase();
    if (mark.kind === 'symbol') return `σ${mark.component}`;
    return mark.text.replace('\u00a0', ' ');
  });
}

const component = (
  index: number,
  of: 'mean' | 'deviation',
  parts: readonly BodyPart[] = [],
): DistanceSentence => ({
  kind: 'component',
  component: index,
  of,
  share: 0.86,
  larger: 'a',
  parts,
});

test('a width, a height, a reach says whose is larger', () => {
  expect(said(explained(component(2, 'mean')))).toBe(
    'A reaches further forward and back (σzz): 86 % of the distance.',
  );
  const of = { ...component(1, 'mean'), larger: 'b' } as DistanceSentence;
  expect(said(explained(of))).toBe('B stretches further up and down (σyy): 86 % of the distance.');
});

test('a lean says what goes with what', () => {
  const legsAndHead = explained(component(4, 'mean', ['head']), [0, 0, 0.26, 0.24, 0.31]);
  expect(said(legsAndHead)).toBe(
    'They differ mainly in lean: how height goes with reach forward (σyz) makes 86 % of the distance. The legs carry 50 % of it, the head 31 %.',
  );
});

test('a deviation says how much something changes, and where more', () => {
  expect(said(explained(component(0, 'deviation')))).toBe(
    'They differ mainly in how much the width changes (σxx): 86 % of the distance. It changes more in A.',
  );
});

test('the same, and a little in everything', () => {
  expect(said(explained({ kind: 'same' }))).toBe('The same.');
  const parts = explained({ kind: 'everything', parts: ['left-arm'] }, [0.45, 0.1, 0.2, 0.15, 0.1]);
  expect(said(parts)).toBe(
    'They differ a little in everything. The left arm carries 45 % of it, the legs 35 %.',
  );
});

test('a mirror image is told', () => {
  expect(said(explained({ kind: 'same' }, [], true))).toContain('B is taken as its mirror image');
});

test('Japanese has no gaps between sentences', () => {
  const arms = explained(component(2, 'mean', ['left-arm', 'right-arm']), [0.33, 0.32, 0, 0, 0]);
  expect(said(arms, 'ja')).toBe(
    'A のほうが前後に大きく伸び（σzz）、これが距離の 86 % を占めます。そのうち両腕が 65 % です。',
  );
});

test('limbs are named together where both are worth naming, or neither alone is', () => {
  const { sentence } = explained({ kind: 'everything', parts: ['left-arm', 'right-arm'] });
  const partShares = {
    'left-arm': 0.4,
    'right-arm': 0.35,
    'left-leg': 0.1,
    'right-leg': 0.1,
    head: 0,
  };
  expect(carriers({ sentence, partShares })).toEqual([['arms', 0.75]]);
});
