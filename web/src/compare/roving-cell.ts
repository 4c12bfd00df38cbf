/**
 * A box on the picture that takes the focus and is spoken: of thousands only one exists. It is made anew
 * with every move, since screen readers speak an element when it takes the focus.
 */
export interface RovingPlace {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

export class RovingCell {
  private current: HTMLElement;

  constructor(
    parent: HTMLElement,
    private readonly make: () => HTMLElement,
  ) {
    this.current = make();
    parent.append(this.current);
  }

  get focused(): boolean {
    return document.activeElement === this.current;
  }

  /** The cell without a move, as where the picture under it has changed. */
  stand({ left, top, width, height }: RovingPlace): void {
    const { style } = this.current;
    style.left = `${left}px`;
    style.top = `${top}px`;
    style.width = `${width}px`;
    style.height = `${height}px`;
  }

  say(text: string): void {
    if (this.current.getAttribute('aria-label') !== text)
      this.current.setAttribute('aria-label', text);
  }

  /** Another cell in its place, in focus if the old one was. */
  renew(text: string, place: RovingPlace): void {
    const { focused } = this;
    const old = this.current;
    this.current = this.make();
    this.say(text);
    this.stand(place);
    old.parentElement?.insertBefore(this.current, old);
    if (focused) this.current.focus({ preventScroll: true });
    old.remove();
  }

  attribute(name: string, value: string): void {
    this.current.setAttribute(name, value);
  }

  focus(): void {
    this.current.focus({ preventScroll: true });
  }
}
