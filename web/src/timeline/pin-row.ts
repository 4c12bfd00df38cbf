/** The pins of the keyposes in view: buttons with one tab stop among them. */
import type { Axis } from './axis';
import { pinWidth, type Pin } from './pin-layout';
import type { TimelineText } from './timeline-text';

export interface PinEvents {
  /** A keypose (index in time order) was chosen. */
  onPick(keypose: number): void;
  /** A lozenge was chosen: its keyposes are to be told apart. */
  onOpen(first: number, last: number): void;
}

export class PinRow {
  readonly element = document.createElement('div');
  private pins: readonly Pin[] = [];
  private readonly buttons = new Map<string, HTMLButtonElement>();
  private readonly pinOf = new WeakMap<Element, Pin>();
  private current: number | null = null;
  /** The keypose that keeps the focus while the pins change about it. */
  private focused: number | null = null;
  private words: TimelineText | null = null;
  private spoken: { frames: Int32Array; frameTimeS: number } = {
    frames: new Int32Array(),
    frameTimeS: 0,
  };

  constructor(private readonly events: PinEvents) {
    this.element.className = 'pin-row';
    this.element.setAttribute('role', 'group');
    this.element.addEventListener('keydown', (event) => this.walk(event));
    this.element.addEventListener('click', (event) => this.click(event));
    this.element.addEventListener('focusin', ({ target }) => {
      this.focused = this.pinOf.get(target as Element)?.first ?? null;
    });
  }

  update(
    pins: readonly Pin[],
    axis: Axis,
    frames: Int32Array,
    frameTimeS: number,
    text: TimelineText,
  ): void {
    if (text !== this.words || frames !== this.spoken.frames) this.forget();
    this.words = text;
    this.spoken = { frames, frameTimeS };
    this.element.setAttribute('aria-label', text.pins);
    this.pins = pins.filter(({ x }) => x > -HALF_HIT && x < axis.width + HALF_HIT);
    const hadFocus = this.element.contains(document.activeElement);
    this.place(text);
    this.markCurrent(this.current);
    if (hadFocus && this.focused !== null) this.buttonOf(this.focused)?.focus();
  }

  markCurrent(keypose: number | null): void {
    this.current = keypose;
    const marked = this.indexOf(keypose);
    this.pins.forEach((pin, index) => {
      const button = this.buttons.get(keyOf(pin))!;
      button.classList.toggle('current', index === marked);
      button.tabIndex = index === Math.max(0, marked) ? 0 : -1;
      if (index === marked) button.setAttribute('aria-current', 'true');
      else button.removeAttribute('aria-current');
    });
  }

  /** The moment of the pin that an element belongs to: the middle one under a lozenge. */
  frameOf(target: EventTarget | null): number | null {
    const pin = target instanceof Element ? this.pinOf.get(target) : undefined;
    return pin === undefined ? null : this.spoken.frames[(pin.first + pin.last) >> 1];
  }

  /** Keeps the buttons of pins that stay, so that panning moves them and makes none. */
  private place(text: TimelineText): void {
    const keys = new Set(this.pins.map(keyOf));
    for (const [key, button] of this.buttons) {
      if (keys.has(key)) continue;
      button.remove();
      this.buttons.delete(key);
    }
    let before: Element | null = null;
    for (const pin of this.pins) {
      const button = this.buttons.get(keyOf(pin)) ?? this.create(pin, text);
      this.pinOf.set(button, pin);
      button.style.transform = `translateX(${pin.x}px)`;
      const next: Element | null =
        before === null ? this.element.firstElementChild : before.nextElementSibling;
      if (next !== button) this.element.insertBefore(button, next);
      before = button;
    }
  }

  private create(pin: Pin, text: TimelineText): HTMLButtonElement {
    const button = document.createElement('button');
    const count = pin.last - pin.first + 1;
    button.type = 'button';
    button.className = count > 1 ? 'pin several' : 'pin';
    if (count > 1) {
      const width = pinWidth(count);
      button.style.width = `${width + 2}px`;
      button.style.marginLeft = `${-width / 2 - 1}px`;
      button.textContent = text.count(count);
    }
    const name = this.nameOf(pin, text);
    button.setAttribute('aria-label', name);
    button.dataset['tip'] = name;
    this.buttons.set(keyOf(pin), button);
    return button;
  }

  private nameOf({ first, last }: Pin, text: TimelineText): string {
    const { frames, frameTimeS } = this.spoken;
    return last > first
      ? text.keyposes(first + 1, last + 1, frames.length)
      : text.keypose(first + 1, frames.length, frames[first] * frameTimeS);
  }

  private forget(): void {
    this.buttons.clear();
    this.element.replaceChildren();
  }

  private click(event: MouseEvent): void {
    const pin = this.pinOf.get(event.target as Element);
    if (pin === undefined) return;
    if (pin.last > pin.first) this.events.onOpen(pin.first, pin.last);
    else this.events.onPick(pin.first);
  }

  private indexOf(keypose: number | null): number {
    if (keypose === null) return -1;
    return this.pins.findIndex((pin) => pin.first <= keypose && keypose <= pin.last);
  }

  private buttonOf(keypose: number): HTMLButtonElement | undefined {
    const pin = this.pins[this.indexOf(keypose)];
    return pin && this.buttons.get(keyOf(pin));
  }

  /** ← → reach every keypose, in view or not: the timeline follows. */
  private walk(event: KeyboardEvent): void {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (step === undefined || event.shiftKey) return;
    event.preventDefault();
    event.stopPropagation();
    const pin = this.pinOf.get(event.target as Element);
    const last = this.spoken.frames.length - 1;
    if (pin === undefined || last < 0) return;
    const from = this.current !== null && this.indexOf(this.current) === this.pins.indexOf(pin);
    const start = from ? this.current! : step > 0 ? pin.last : pin.first;
    const next = Math.min(last, Math.max(0, start + step));
    this.focused = next;
    this.buttonOf(next)?.focus();
    this.focused = next;
    this.events.onPick(next);
  }
}

const HALF_HIT = 12;

const keyOf = ({ first, last }: Pin): string => `${first}-${last}`;
