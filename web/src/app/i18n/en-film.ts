/** The sentences of films in English. */
import type { Message } from './message';

export const englishFilm = {
  film: 'Film',
  'film.title': 'Pair as film',
  'film.size': 'Size',
  'film.rate': 'Frames per second',
  'film.length': '{0} s · {1} frames',
  'film.all': 'The whole pair',
  'film.loop': 'A–B, {0} to {1} s',
  'film.speed': '{0}× speed',
  'film.about': 'As the stages show it now.',
  'film.save': 'Save film',
  'film.cancel': 'Cancel',
  'film.stop': 'Cancel the film',
  'film.progress': 'Frame {0} of {1}',
  'film.name': '{0} with {1}',
  'film.no-encoder':
    'This browser cannot encode films; current versions of Chrome, Edge, Firefox and Safari can.',
  'film.waits': 'The time warp is still being found.',
  'film.failed': 'The film stopped: {0} Try again.',
  'film.failed.no-codec':
    'This browser cannot encode a film of this size: choose the smaller one, or another browser.',
  'film.failed.no-graphics': 'The graphics gave out: close other pages that draw, then try again.',
} satisfies Readonly<Record<string, Message>>;
