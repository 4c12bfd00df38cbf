/** Wishes in; films as files in the person's downloads out, one at a time, each with its progress. */
import { signal, type ReadonlySignal } from '@preact/signals-core';
import type { Context } from '../app/context';
import { isAbort } from '../app/failure';
import { saveBlob } from '../common/save-file';
import type { FilmShape } from '../film/film-shape';
import { filmTimes } from '../film/film-times';
import type { FilmUnderWay } from './film-button';
import { filmFailure } from './film-failure';
import type { FilmWish } from './film-wish';

export interface FilmMaker {
  readonly underWay: ReadonlySignal<FilmUnderWay | null>;
  /** Settles when the film is saved, cancelled, or its failure told. */
  readonly make: (shape: FilmShape) => Promise<void>;
  readonly cancel: () => void;
}

export function createFilmMaker(context: Context, wishNow: () => FilmWish): FilmMaker {
  const underWay = signal<FilmUnderWay | null>(null);
  let abort = new AbortController();
  const make = async (shape: FilmShape): Promise<void> => {
    const { store, language, engine } = context;
    const wish = wishNow();
    const { count } = filmTimes(wish.stretch, shape.rate_hz);
    const [a, b] = wish.clips.map(({ name }) => name);
    const fileName = `${language.words.peek().t('film.name', a, b)}.webm`;
    abort = new AbortController();
    const { signal } = abort;
    const startMs = performance.now();
    const onProgress = (done: number): void => {
      if (signal.aborted) return;
      underWay.value = { done, count, elapsedS: (performance.now() - startMs) / 1000 };
    };
    onProgress(0);
    try {
      const { makeFilm } = await import('./make-film');
      const film = await makeFilm(engine, wish, shape, { signal, onProgress });
      saveBlob(fileName, film);
      store.toast.value = { kind: 'done', text: language.words.peek().t('toast.saved', fileName) };
    } catch (error) {
      if (signal.aborted || isAbort(error)) return;
      const words = language.words.peek();
      const text = words.t('toast.error', fileName, filmFailure(words, error));
      store.toast.value = { kind: 'error', text };
    }
    underWay.value = null;
  };
  const cancel = (): void => {
    abort.abort();
    underWay.value = null;
  };
  return { underWay, make, cancel };
}
