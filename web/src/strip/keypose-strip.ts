/** The keypose strip: a figure for each keypose of the visible span, in reading order, tied to its pin. */
import './keypose-strip.css';
import { element } from '../common/element';
import type { KeyposeResult, PerformerResult } from '../engine/types';
import { type FlatFigure, flatFigure } from '../figure/flat-figure';
import { Axis, type AxisSpan, GUTTER_WIDTH } from '../timeline/axis';
import { layoutPins } from '../timeline/pin-layout';
import { StripCard } from './strip-card';
import {
  type Card,
  labelDigits,
  layoutStrip,
  leastLabelWidth,
  SMALLEST_CARD,
  stripScale,
} from './strip-layout';
import { StripThreads } from './strip-threads';

/** Sentences and numbers in the reader's language. */
export interface StripText {
  readonly strip: string;
  readonly keyposes: string;
  /** Shown instead of figures when a clip has no keyposes. */
  readonly none: string;
  count(value: number): string;
  /** A keypose's number and its seconds as labels: without marks between thousands. */
  number(value: number): string;
  seconds(timeS: number, digits: number): string;
  /** "16 of 212 shown". */
  shown(shown: number, all: number): string;
  /** "Keypose 3 of 11, 2.82 seconds". */
  keypose(index: number, count: number, timeS: number): string;
}

/** Poses that have arrived, by frame: joints × 3, world, file units. */
export interface StripPoses {
  get(frame: number): Float32Array | undefined;
}

export interface StripProps {
  readonly frames: number;
  readonly frameTimeS: number;
  readonly span: AxisSpan;
  readonly performer: PerformerResult;
  readonly keyposes: KeyposeResult | null;
  /** Another object whenever more have arrived. */
  readonly poses: StripPoses;
  readonly currentKeypose: number | null;
  readonly text: StripText;
}

export interface StripEvents {
  /** A keypose (index in time order) was chosen. */
  onPick(keypose: number): void;
  /** The moment under the pointer. */
  onHover(frame: number | null): void;
  /** The frames whose figures are shown: their poses are needed. */
  onShown(frames: Int32Array): void;
}

const placed = ['frames', 'span', 'keyposes', 'performer', 'poses', 'text'] as const;

export class KeyposeStrip {
  private readonly root = element('section', 'strip');
  private readonly area = element('div', 'strip-area');
  private readonly title = element('span', 'strip-title');
  private readonly number = element('strong', 'strip-count');
  private readonly remark = element('span', 'strip-remark');
  private readonly cards = element('div', 'strip-cards');
  private readonly threads = new StripThreads();
  private readonly cardOf = new Map<number, StripCard>();
  private readonly observer: ResizeObserver;
  private figures = new Map<number, FlatFigure>();
  private frames = new Int32Array();
  /** The keypose that the keyboard has walked to, until the time goes elsewhere. */
  private walked: number | null = null;

  constructor(
    target: HTMLElement,
    private props: StripProps,
    private readonly events: StripEvents,
  ) {
    const gutter = element('div', 'strip-gutter');
    gutter.append(this.title, this.number, this.remark);
    this.cards.setAttribute('role', 'group');
    this.area.append(this.threads.element, this.cards);
    this.root.append(gutter, this.area);
    target.append(this.root);
    this.listen();
    this.observer = new ResizeObserver(() => this.layout());
    this.observer.observe(this.area);
    this.layout();
  }

  /** Takes new properties and redraws what depends on them. */
  update(changes: Partial<StripProps>): void {
    const before = this.props;
    this.props = { ...before, ...changes };
    if (this.props.performer !== before.performer) this.figures.clear();
    if (this.props.currentKeypose !== this.walked) this.walked = null;
    if (placed.some((key) => this.props[key] !== before[key])) this.layout();
    else if (this.props.currentKeypose !== before.currentKeypose) this.markCurrent();
  }

  destroy(): void {
    this.observer.disconnect();
    this.root.remove();
  }

  private layout(): void {
    const { frames, keyposes, span } = this.props;
    const width = Math.max(0, this.root.clientWidth - GUTTER_WIDTH);
    const axis = new Axis(width, Math.max(0, frames - 1), span);
    this.frames = keyposeFrames(keyposes);
    const intensities = Array.from(keyposes?.keyposes ?? [], (c) => keyposes!.intensities[c]);
    const x = Array.from(this.frames, (frame) => axis.x(frame));
    const room = { ...this.visible(), kept: this.walked, width, leastCard: this.leastCard() };
    const { cards, cardWidth } = layoutStrip(x, intensities, room);
    this.writeGutter(cards.length);
    this.events.onShown(Int32Array.from(cards, ({ keypose }) => this.frames[keypose]));
    this.placeCards(cards, cardWidth);
    this.threads.update(cards, pinPlaces(this.frames, axis), width);
    this.markCurrent();
  }

  /** The keyposes within the span. */
  private visible(): { first: number; end: number } {
    const { first, last } = this.props.span;
    const after = this.frames.findIndex((frame) => frame > last);
    const start = this.frames.findIndex((frame) => frame >= first);
    const end = after < 0 ? this.frames.length : after;
    return { first: start < 0 ? end : start, end };
  }

  /** So wide that the longest text of a card fits. */
  private leastCard(): number {
    const lastS = (this.frames.at(-1) ?? 0) * this.props.frameTimeS;
    return Math.max(SMALLEST_CARD, leastLabelWidth(this.frames.length, lastS));
  }

  private writeGutter(shown: number): void {
    const { text } = this.props;
    const all = this.frames.length;
    this.root.setAttribute('aria-label', text.strip);
    this.cards.setAttribute('aria-label', text.strip);
    this.title.textContent = text.keyposes;
    this.number.textContent = text.count(all);
    this.remark.textContent = all === 0 ? text.none : shown < all ? text.shown(shown, all) : '';
  }

  /** Cards that stay are moved, not made anew: the focus and the figure stay with them. */
  private placeCards(cards: readonly Card[], width: number): void {
    const shown = new Set(cards.map(({ keypose }) => keypose));
    const gone = [...this.cardOf].filter(([keypose]) => !shown.has(keypose));
    for (const [keypose] of gone) this.cardOf.delete(keypose);
    const figures = cards.map(({ keypose }) => this.figureOf(keypose));
    const scale = stripScale(
      figures.filter((figure) => figure !== null),
      width,
    );
    const goneButtons = new Set<ChildNode>(gone.map(([, { button }]) => button));
    let next = this.cards.firstChild;
    cards.forEach((place, index) => {
      const card = this.card(place.keypose);
      while (next && goneButtons.has(next)) next = next.nextSibling;
      if (card.button === next) next = next.nextSibling;
      else this.cards.insertBefore(card.button, next);
      card.update({ ...this.words(place, width), x: place.x, figure: figures[index], scale });
    });
    this.keepFocus(goneButtons);
    for (const button of goneButtons) button.remove();
  }

  /** The focus goes where the keyboard walked to, and from a card that goes to one that stays. */
  private keepFocus(gone: ReadonlySet<ChildNode>): void {
    const active = document.activeElement;
    if (active === null || !this.cards.contains(active)) return;
    const walked = this.walked === null ? undefined : this.cardOf.get(this.walked);
    const stays = gone.has(active) ? this.cardOf.get(this.firstShown()) : undefined;
    (walked ?? stays)?.button.focus();
  }

  private words({ keypose }: Card, width: number) {
    const { text, frameTimeS } = this.props;
    const number = keypose + 1;
    const timeS = this.frames[keypose] * frameTimeS;
    return {
      width,
      number: text.number(number),
      seconds: text.seconds(timeS, labelDigits(number, timeS, width)),
      spoken: text.keypose(number, this.frames.length, timeS),
    };
  }

  private card(keypose: number): StripCard {
    let card = this.cardOf.get(keypose);
    if (card === undefined) {
      card = new StripCard();
      card.button.dataset['keypose'] = String(keypose);
      this.cardOf.set(keypose, card);
    }
    return card;
  }

  /** null while its pose is on its way. */
  private figureOf(keypose: number): FlatFigure | null {
    const { performer, poses } = this.props;
    const frame = this.frames[keypose];
    const known = this.figures.get(frame);
    const pose = known ? undefined : poses.get(frame);
    if (pose === undefined) return known ?? null;
    const figure = flatFigure(pose, performer, performer.sideYawRad);
    this.figures.set(frame, figure);
    return figure;
  }

  private markCurrent(): void {
    const { currentKeypose } = this.props;
    const stop = this.cardOf.has(currentKeypose ?? -1) ? currentKeypose : this.firstShown();
    for (const [keypose, card] of this.cardOf) {
      card.setCurrent(keypose === currentKeypose);
      card.button.tabIndex = keypose === stop ? 0 : -1;
    }
    this.threads.markCurrent(currentKeypose);
  }

  private firstShown(): number {
    return Math.min(...this.cardOf.keys());
  }

  private listen(): void {
    this.cards.addEventListener('keydown', (event) => this.walk(event));
    this.cards.addEventListener('focusout', ({ relatedTarget }) => {
      if (!this.cards.contains(relatedTarget as Node | null)) this.walked = null;
    });
    this.cards.addEventListener('click', ({ target }) => {
      const keypose = keyposeAt(target);
      if (keypose !== null) this.events.onPick(keypose);
    });
    this.area.addEventListener('pointerover', ({ target }) => {
      const keypose = keyposeAt(target);
      this.events.onHover(keypose === null ? null : (this.frames[keypose] ?? null));
    });
    this.area.addEventListener('pointerleave', () => this.events.onHover(null));
  }

  /** ← → reach every keypose, shown or not: one that is not gets its card. */
  private walk(event: KeyboardEvent): void {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    const modified = event.shiftKey || event.ctrlKey || event.metaKey || event.altKey;
    if (step === undefined || modified || this.frames.length === 0) return;
    event.preventDefault();
    event.stopPropagation();
    const from = this.walked ?? this.focused() ?? this.props.currentKeypose ?? 0;
    const next = Math.min(this.frames.length - 1, Math.max(0, from + step));
    this.walked = next;
    this.events.onPick(next);
    this.layout();
  }

  private focused(): number | null {
    for (const [keypose, { button }] of this.cardOf)
      if (button === document.activeElement) return keypose;
    return null;
  }
}

/** The keypose whose card an event came from. */
function keyposeAt(target: EventTarget | null): number | null {
  const card = target instanceof Element ? target.closest<HTMLElement>('.keypose-card') : null;
  return card === null ? null : Number(card.dataset['keypose']);
}

/** The frames of the keyposes, in time order. */
function keyposeFrames(keyposes: KeyposeResult | null): Int32Array<ArrayBuffer> {
  return Int32Array.from(keyposes?.keyposes ?? [], (c) => keyposes!.candidates[c]);
}

/** Where the pin of each keypose stands; several may share one. */
function pinPlaces(frames: Int32Array, axis: Axis): Float64Array {
  const places = new Float64Array(frames.length);
  for (const { x, first, last } of layoutPins(frames, axis)) places.fill(x, first, last + 1);
  return places;
}
