/**
 * Errors of a worker in; the failures that they stand for out.
 */
import { failureOf } from './failures';
import { CoreFailure } from './core-failure';
import type { Failure } from './types';
import { ZipError } from './zip-directory';

/** The failure that an error stands for; null where it stands for none. */
export function failureIn(error: unknown): Failure | null {
  if (error instanceof CoreFailure) return error.failure;
  if (error instanceof ZipError) return failureOf(error.kind);
  return error instanceof DOMException ? failureOf('not-readable') : null;
}

/** A Blob that cannot be read any more belongs to a file that was changed or removed. */
export function readingError(error: unknown, readBefore: boolean): unknown {
  if (!(error instanceof DOMException)) return error;
  return new CoreFailure(failureOf(readBefore ? 'changed-on-disk' : 'not-readable'));
}
