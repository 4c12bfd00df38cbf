/**
 * What the core throws on purpose in; an error that holds the failure out.
 */
import type { Failure } from './types';

/** A failure that the core has found in a file or an option. */
export class CoreFailure extends Error {
  readonly failure: Failure;

  constructor(failure: Failure) {
    super(failure.kind);
    this.name = 'CoreFailure';
    this.failure = failure;
  }
}

/** Runs a call into the core; what it throws on purpose is a failure written as JSON. */
export function refusing<T>(call: () => T): T {
  try {
    return call();
  } catch (error) {
    if (error instanceof Error && error.message.startsWith('{')) {
      throw new CoreFailure(JSON.parse(error.message) as Failure);
    }
    throw error;
  }
}
