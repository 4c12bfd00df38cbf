/**
 * A key press in; the command that it stands for out. Keys mean nothing while somebody writes or chooses
 * in a field; Space and Enter belong to the button in focus.
 */
export type KeyCommand =
  | 'play'
  | 'frame-back'
  | 'frame-on'
  | 'tenth-back'
  | 'tenth-on'
  | 'next-keypose'
  | 'previous-keypose'
  | 'first-frame'
  | 'last-frame'
  | 'slower'
  | 'faster'
  | 'loop'
  | 'loop-start'
  | 'loop-end'
  | 'loop-clear'
  | 'zoom-in'
  | 'zoom-out'
  | 'zoom-all'
  | 'full-screen'
  | 'help'
  | 'filter'
  | 'undo'
  | 'redo';

export interface KeyPress {
  readonly key: string;
  readonly shiftKey: boolean;
  readonly ctrlKey: boolean;
  readonly metaKey: boolean;
  readonly altKey: boolean;
}

/**
 * What the keyboard is in: a field takes every key, but undo where nothing is written that is not taken
 * yet (a settled field); a button that was reached by key takes Space.
 */
export type KeyFocus = 'page' | 'button' | 'field' | 'settled-field';

const plainKeys: Readonly<Record<string, KeyCommand>> = {
  ' ': 'play',
  ArrowLeft: 'frame-back',
  ArrowRight: 'frame-on',
  k: 'next-keypose',
  Home: 'first-frame',
  End: 'last-frame',
  '-': 'slower',
  '+': 'faster',
  '=': 'faster',
  l: 'loop',
  '[': 'loop-start',
  ']': 'loop-end',
  z: 'zoom-in',
  '0': 'zoom-all',
  f: 'full-screen',
  '?': 'help',
  '/': 'filter',
};

/** Signs such as `?`, `+` and `[` need Shift on some keyboards and not on others. */
const shiftKeys: Readonly<Record<string, KeyCommand>> = {
  ArrowLeft: 'tenth-back',
  ArrowRight: 'tenth-on',
  k: 'previous-keypose',
  l: 'loop-clear',
  z: 'zoom-out',
  '[': 'loop-start',
  ']': 'loop-end',
  '+': 'faster',
  '?': 'help',
  '/': 'filter',
  '-': 'slower',
};

function historyCommand(key: string, shift: boolean): KeyCommand | null {
  if (key === 'z') return shift ? 'redo' : 'undo';
  return key === 'y' && !shift ? 'redo' : null;
}

/** Signs that some keyboards write only with Alt, or with AltGr, which reads as Ctrl and Alt. */
const altKeys: Readonly<Record<string, KeyCommand>> = { '[': 'loop-start', ']': 'loop-end' };

export function commandFor(press: KeyPress, focus: KeyFocus): KeyCommand | null {
  if (focus === 'field') return null;
  const key = press.key.length === 1 ? press.key.toLowerCase() : press.key;
  if ((press.ctrlKey || press.metaKey) && !press.altKey) return historyCommand(key, press.shiftKey);
  if (focus === 'settled-field') return null;
  if (press.altKey) return altKeys[key] ?? null;
  if (key === ' ' && focus === 'button') return null;
  return (press.shiftKey ? shiftKeys : plainKeys)[key] ?? null;
}

const writtenInputs = new Set(['checkbox', 'radio', 'button', 'file', 'submit']);

const buttons = 'button, a[href], summary, [role="menuitem"], [role="menuitemradio"]';

/** A field says by its default what the page took last. */
function focusOfInput({ type, value, defaultValue }: HTMLInputElement): KeyFocus {
  if (writtenInputs.has(type)) return 'button';
  return value !== '' && value === defaultValue ? 'settled-field' : 'field';
}

/** `reachedByKey`: whether the focus came by the Tab key or the like, not by a press of the pointer. */
export function focusOf(target: EventTarget | null, reachedByKey: boolean): KeyFocus {
  if (!(target instanceof HTMLElement)) return 'page';
  if (target.isContentEditable || target.matches('textarea')) return 'field';
  if (target instanceof HTMLSelectElement) return 'settled-field';
  if (target instanceof HTMLInputElement) return focusOfInput(target);
  // A row of the library opens as soon as it is reached: Space is free to play it.
  const takesSpace = target.closest(buttons) !== null && target.dataset['space'] !== 'plays';
  return takesSpace && reachedByKey ? 'button' : 'page';
}

/** Tells how the element in focus was reached: by what was pressed last before it was. */
function watchFocus(target: Document): () => boolean {
  let pointed = false;
  let reachedByPointer = false;
  target.addEventListener('pointerdown', () => (pointed = true), true);
  target.addEventListener('keydown', () => (pointed = false), true);
  target.addEventListener('focusin', () => (reachedByPointer = pointed));
  return () => !reachedByPointer;
}

/** Listens on a document; whoever handles a key first keeps it by `preventDefault`. */
export function listenToKeys(target: Document, run: (command: KeyCommand) => void): void {
  const reachedByKey = watchFocus(target);
  target.addEventListener('keydown', (event) => {
    const modal = target.querySelector('dialog[open]') !== null;
    if (event.defaultPrevented || event.isComposing || modal) return;
    const command = commandFor(event, focusOf(event.target, reachedByKey()));
    if (!command) return;
    event.preventDefault();
    run(command);
  });
}
