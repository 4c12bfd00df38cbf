/** Every key that the page knows, by what it is about: what the list of keys shows. */
import type { MessageKey } from '../app/i18n/catalogue';

type KeySign = '←' | '→' | '↑' | '↓' | '-' | '+' | '[' | ']' | '/' | '?';
export type KeyName = MessageKey | KeySign | 'A' | 'F' | 'F2' | 'K' | 'L' | 'Z' | '0' | 'Esc';
/** Keys pressed together; alternatives stand side by side. */
export type KeyLine = readonly [MessageKey, ...(readonly KeyName[])[]];
/** Under a title. */
export type KeyTable = readonly [MessageKey, readonly KeyLine[]];

const playbackKeys: readonly KeyLine[] = [
  ['help.play', ['help.space']],
  ['help.frame', ['←'], ['→']],
  ['help.tenth', ['key.shift', '←'], ['key.shift', '→']],
  ['help.keypose', ['K'], ['key.shift', 'K']],
  ['help.ends', ['key.home'], ['key.end']],
  ['help.speed', ['-'], ['+']],
];

const loopKeys: readonly KeyLine[] = [
  ['help.loop', ['L']],
  ['help.loop-ends', ['['], [']']],
  ['help.loop-clear', ['key.shift', 'L']],
];

/** Of the study and of the pair. */
const timelineKeys: readonly KeyLine[] = [
  ['help.zoom', ['Z'], ['key.shift', 'Z']],
  ['help.zoom-all', ['0']],
];

const libraryKeys: readonly KeyLine[] = [
  ['help.clips', ['↑'], ['↓']],
  ['help.select-on', ['key.shift', '↑'], ['key.shift', '↓']],
  ['help.select', ['key.ctrl', 'help.space']],
  ['help.select-all', ['key.ctrl', 'A']],
  ['library.ticked.clear', ['Esc']],
  ['help.rename', ['F2']],
  ['help.remove', ['key.delete']],
  ['help.filter', ['/']],
];

const pageKeys: readonly KeyLine[] = [
  ['help.full-screen', ['F']],
  ['help.undo', ['key.ctrl', 'Z']],
  ['help.redo', ['key.ctrl', 'key.shift', 'Z']],
  ['help.this', ['?']],
];

export const columns: readonly (readonly KeyTable[])[] = [
  [
    ['help.playback', playbackKeys],
    ['help.loop-title', loopKeys],
  ],
  [['library.title', libraryKeys]],
  [
    ['help.timeline', timelineKeys],
    ['help.page', pageKeys],
  ],
];
