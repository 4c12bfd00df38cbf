/** A press on a button in; the button in focus out: Safari leaves the focus where it was, and keys with it. */
export function focusPressed(target: Document): void {
  // Before the button's own handler, which may move the focus on.
  const focus = (event: MouseEvent): void => {
    const button = event.target instanceof Element ? event.target.closest('button') : null;
    if (button !== target.activeElement) button?.focus({ preventScroll: true });
  };
  target.addEventListener('click', focus, true);
}
