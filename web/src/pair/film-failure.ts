/** Why there is no film; what the page says of it out. */
import { failureOf } from '../app/failure';
import type { Words } from '../app/i18n/catalogue';

export class FilmFailure extends Error {
  constructor(readonly kind: 'no-codec' | 'no-graphics') {
    super(kind);
  }
}

/** One sentence with what to do. */
export function filmFailure({ t, failure }: Words, error: unknown): string {
  if (error instanceof FilmFailure) return t(`film.failed.${error.kind}`);
  return t('film.failed', failure(failureOf(error)));
}
