import { signal } from '@preact/signals-core';
import { beforeEach, expect, test, vi } from 'vitest';
import type { Words } from '../app/i18n/catalogue';
import type { Toast } from '../app/store';
import { filmShape } from '../film/film-shape';
import { createFilmMaker } from './film-maker';
import { FilmFailure } from './film-failure';
import type { FilmWish } from './film-wish';

const { makeFilm, saveBlob } = vi.hoisted(() => ({ makeFilm: vi.fn(), saveBlob: vi.fn() }));
vi.mock('./make-film', () => ({ makeFilm }));
vi.mock('../common/save-file', () => ({ saveBlob }));

const words = {
  t: (...parts: string[]) => parts.join(' '),
  failure: ({ details }: { details: string[] }) => details.join(),
} as unknown as Words;
const wish = {
  words,
  clips: [{ name: 'walk' }, { name: 'run' }],
  stretch: { fromS: 0, toS: 1, speed: 1 },
} as unknown as FilmWish;
const shape = filmShape(720, 25);
const never = new Promise<never>(() => undefined);

function maker(wishNow = () => wish) {
  const toast = signal<Toast | null>(null);
  const parts = { store: { toast }, language: { words: signal(words) }, engine: {} };
  const context = parts as unknown as Parameters<typeof createFilmMaker>[0];
  return { ...createFilmMaker(context, wishNow), toast };
}

beforeEach(() => {
  makeFilm.mockReset();
  saveBlob.mockReset();
});

test('a film is saved and told', async () => {
  makeFilm.mockResolvedValue('film');
  const { make, toast, underWay } = maker();
  await make(shape);
  expect(saveBlob).toHaveBeenCalledWith('film.name walk run.webm', 'film');
  expect(toast.value).toEqual({ kind: 'done', text: 'toast.saved film.name walk run.webm' });
  expect(underWay.value).toBeNull();
});

test('whatever keeps a film from being made is told, also before it has begun', async () => {
  const failing = maker(() => {
    throw new Error('no camera');
  });
  await failing.make(shape);
  expect(failing.toast.value?.text).toBe('toast.error film.title film.failed no camera');
  makeFilm.mockRejectedValue(new FilmFailure('no-codec'));
  const { make, toast, underWay } = maker();
  await make(shape);
  expect(toast.value?.text).toBe('toast.error film.name walk run.webm film.failed.no-codec');
  expect(underWay.value).toBeNull();
});

test('work that was stopped by another than the person is told too', async () => {
  makeFilm.mockRejectedValue(new DOMException('the clip has gone', 'AbortError'));
  const { make, toast, underWay } = maker();
  await make(shape);
  expect(toast.value?.text).toContain('the clip has gone');
  expect(underWay.value).toBeNull();
});

test('a cancel ends a film that hangs, at once and without a word', async () => {
  makeFilm.mockReturnValue(never);
  const { make, cancel, toast, underWay } = maker();
  const made = make(shape);
  await vi.waitFor(() => expect(makeFilm).toHaveBeenCalled());
  expect(underWay.value).toMatchObject({ done: 0, count: 26 });
  cancel();
  expect(underWay.value).toBeNull();
  await made;
  expect(toast.value).toBeNull();
  expect(saveBlob).not.toHaveBeenCalled();
});

test('the end of a cancelled film leaves the next one alone', async () => {
  makeFilm.mockReturnValue(never);
  const { make, cancel, underWay } = maker();
  const first = make(shape);
  cancel();
  void make(shape);
  await first;
  expect(underWay.value).toMatchObject({ done: 0 });
});
