/** Whatever a promise was rejected with in; what the page tells about it out. */
import { EngineError, type Failure } from '../engine/types';

export const isAbort = (error: unknown): boolean =>
  error instanceof DOMException && error.name === 'AbortError';

export function failureOf(error: unknown): Failure {
  if (error instanceof EngineError) return error.failure;
  const text = error instanceof Error ? error.message : String(error);
  return { kind: 'internal', line: null, column: null, details: [text] };
}
