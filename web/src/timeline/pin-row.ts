/** The pins of the keyposes: a list with one tab stop, each pin a button. */
import type { Pin } from './pin-layout';
import type { TimelineText } from './timeline-text';

export class PinRow {
  readonly element = document.createElement('div');
  private pins: readonly Pin[] = [];
  private buttons: HTMLButtonElement[] = [];
  private current: number | null = null;

  /** @param onPick gets the index of the keypose to go to */
  constructor(private readonly onPick: (keypose: number) => void) {
    this.element.className = 'pin-row';
    this.element.setAttribute('role', 'group');
    this.element.addEventListener('keydown', (event) => this.walk(event));
  }

  update(pins: readonly Pin[], frames: Int32Array, frameTimeS: number, text: TimelineText): void {
    this.pins = pins;
    this.element.setAttribute('aria-label', text.pins);
    this.buttons = pins.map((pin) => this.button(pin, frames, frameTimeS, text));
    this.element.replaceChildren(...this.buttons);
  }

  /** The pin of the current keypose, -1 if there is none. */
  get currentPin(): number {
    const { current } = this;
    if (current === null) return -1;
    return this.pins.findIndex((pin) => pin.first <= current && current <= pin.last);
  }

  markCurrent(keypose: number | null): void {
    this.current = keypose;
    const marked = this.currentPin;
    this.buttons.forEach((button, index) => {
      button.classList.toggle('current', index === marked);
      button.tabIndex = index === Math.max(0, marked) ? 0 : -1;
      if (index === marked) button.setAttribute('aria-current', 'true');
      else button.removeAttribute('aria-current');
    });
  }

  private button(
    pin: Pin,
    frames: Int32Array,
    frameTimeS: number,
    text: TimelineText,
  ): HTMLButtonElement {
    const button = document.createElement('button');
    const several = pin.last > pin.first;
    button.type = 'button';
    button.className = several ? 'pin several' : 'pin';
    button.style.left = `${pin.x}px`;
    button.textContent = several ? text.count(pin.last - pin.first + 1) : '';
    const name = several
      ? text.keyposes(pin.first + 1, pin.last + 1, frames.length)
      : text.keypose(pin.first + 1, frames.length, frames[pin.first] * frameTimeS);
    button.setAttribute('aria-label', name);
    button.title = name;
    button.addEventListener('click', () => this.onPick(this.next(pin)));
    return button;
  }

  /** The pin's keypose, or the one after the current within a lozenge, so that clicks reach all. */
  private next(pin: Pin): number {
    const { current } = this;
    const inside = current !== null && current >= pin.first && current < pin.last;
    return inside ? current + 1 : pin.first;
  }

  private walk(event: KeyboardEvent): void {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (step === undefined || event.shiftKey) return;
    event.preventDefault();
    event.stopPropagation();
    const from = this.buttons.indexOf(document.activeElement as HTMLButtonElement);
    const to = Math.min(this.pins.length - 1, Math.max(0, from + step));
    this.buttons[to]?.focus();
    if (this.pins[to] !== undefined) this.onPick(this.pins[to].first);
  }
}
