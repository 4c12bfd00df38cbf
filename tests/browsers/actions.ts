// Presses of keys and of the pointer, as WebDriver and WebDriver BiDi both write them.

/** All are held, one after the other, then let go. */
export function keyActions(keys: readonly string[]): object {
  const down = keys.map((value) => ({ type: 'keyDown', value }));
  const up = keys.map((value) => ({ type: 'keyUp', value })).reverse();
  return { type: 'key', id: 'keyboard', actions: [...down, ...up] };
}

export function clickActions(x: number, y: number): object {
  const actions = [
    { type: 'pointerMove', x, y, duration: 0 },
    { type: 'pointerDown', button: 0 },
    { type: 'pointerUp', button: 0 },
  ];
  return { type: 'pointer', id: 'mouse', actions };
}
