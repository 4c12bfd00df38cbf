/**
 * Failures that are about the engine, an archive or the disk, not about a place in a file.
 */
import type { Failure, PerformerResult } from './types';

/** Every kind of them; those of reading and analysis are named in the core. */
export const ENGINE_FAILURES = [
  'archive-damaged',
  'archive-entry-encrypted',
  'archive-entry-method',
  'archive-too-large',
  'archive-without-motions',
  'changed-on-disk',
  'compared-again',
  'comparison-stopped',
  'engine-unavailable',
  'no-such-sample',
  'not-an-archive',
  'not-human-to-compare',
  'not-open',
  'not-readable',
  'out-of-memory',
  'too-many-pairs',
  'too-short-to-compare',
  'worker-died',
] as const;

export type EngineFailureKind = (typeof ENGINE_FAILURES)[number];

/** A failure of one of these kinds. */
export function failureOf(kind: EngineFailureKind, ...details: string[]): Failure {
  return { kind, line: null, column: null, details };
}

/** Why none of these performers can be compared. */
export function incomparableOf(performers: readonly Pick<PerformerResult, 'body'>[]): Failure {
  const human = performers.some(({ body }) => body.kind === 'human');
  return failureOf(human ? 'too-short-to-compare' : 'not-human-to-compare');
}
