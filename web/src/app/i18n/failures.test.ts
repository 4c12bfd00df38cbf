import { expect, it } from 'vitest';
import { ENGINE_FAILURES } from '../../engine/failures';
import { englishFailures } from './en-notes';
import { japaneseFailures } from './ja-notes';

it('has a sentence for every failure of the engine, in both languages', () => {
  for (const kind of [...ENGINE_FAILURES, 'setting']) {
    expect(englishFailures, kind).toHaveProperty(kind);
    expect(japaneseFailures, kind).toHaveProperty(kind);
  }
  expect(Object.keys(japaneseFailures).sort()).toEqual(Object.keys(englishFailures).sort());
});
