/** Wishes in; films as files in the person's downloads out, one at a time, each with its progress. */
import { signal, type ReadonlySignal } from '@preact/signals-core';
import type { Context } from '../app/context';
import { saveBlob } from '../common/save-file';
import type { FilmShape } from '../film/film-shape';
import { filmTimes } from '../film/film-times';
import type { FilmUnderWay } from './film-button';
import { filmFailure } from './film-failure';
import type { FilmWish } from './film-wish';
import { unlessAborted } from './unless-aborted';

export interface FilmMaker {
  readonly underWay: ReadonlySignal<FilmUnderWay | null>;
  /** Settles when the film is saved, cancelled, or its failure told. */
  readonly make: (shape: FilmShape) => Promise<void>;
  readonly cancel: () => void;
}

type MakerContext = Pick<Context, 'engine' | 'language'> & {
  readonly store: Pick<Context['store'], 'toast'>;
};

export function createFilmMaker(context: MakerContext, wishNow: () => FilmWish): FilmMaker {
  const { store, language, engine } = context;
  const underWay = signal<FilmUnderWay | null>(null);
  let abort = new AbortController();
  const film = async (wish: FilmWish, shape: FilmShape, { signal }: AbortController) => {
    const { count } = filmTimes(wish.stretch, shape.rate_hz);
    const startMs = performance.now();
    const onProgress = (done: number): void => {
      if (signal.aborted) return;
      underWay.value = { done, count, elapsedS: (performance.now() - startMs) / 1000 };
    };
    onProgress(0);
    const { makeFilm } = await import('./make-film');
    signal.throwIfAborted();
    return makeFilm(engine, wish, shape, { signal, onProgress });
  };
  const make = async (shape: FilmShape): Promise<void> => {
    const own = (abort = new AbortController());
    const { words } = language;
    let name = words.peek().t('film.title');
    try {
      const wish = wishNow();
      name = fileName(wish);
      saveBlob(name, await unlessAborted(own.signal, film(wish, shape, own)));
      store.toast.value = { kind: 'done', text: words.peek().t('toast.saved', name) };
    } catch (error) {
      // Who cancels knows it, and may have begun another since.
      if (own.signal.aborted) return;
      const text = words.peek().t('toast.error', name, filmFailure(words.peek(), error));
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

function fileName({ clips, words }: FilmWish): string {
  const [a, b] = clips.map(({ name }) => name);
  return `${words.t('film.name', a, b)}.webm`;
}
