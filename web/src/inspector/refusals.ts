/**
 * What a person wrote and could not be taken, with the sentence that says why, by field. A refusal holds
 * as long as its basis: what the field would show otherwise.
 */
import { signal } from '@preact/signals-core';

export interface Refusals {
  /** The sentence for a field; null while there is none. */
  readonly of: (field: string, basis: string) => string | null;
  readonly set: (field: string, basis: string, sentence: string | null) => void;
}

interface Refused {
  readonly basis: string;
  readonly sentence: string;
}

export function createRefusals(): Refusals {
  const refused = signal<ReadonlyMap<string, Refused>>(new Map());
  return {
    of(field, basis) {
      const entry = refused.value.get(field);
      return entry?.basis === basis ? entry.sentence : null;
    },
    set(field, basis, sentence) {
      const next = new Map(refused.peek());
      if (sentence === null) next.delete(field);
      else next.set(field, { basis, sentence });
      refused.value = next;
    },
  };
}
