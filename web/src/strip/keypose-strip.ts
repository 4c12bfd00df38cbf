/** The keypose strip: one figure for each keypose in reading order, tied by threads to the pins. */
import './keypose-strip.css';
import { element } from '../common/element';
import type { KeyposeResult, PerformerResult } from '../engine/types';
import { drawFlatFigure } from '../figure/draw-flat-figure';
import { type FlatFigure, flatFigure } from '../figure/flat-figure';
import { Axis, GUTTER_WIDTH } from '../timeline/axis';
import { type Card, labelDigits, layoutStrip, stripScale } from './strip-layout';

/** Sentences and numbers in the reader's language. */
export interface StripText {
  readonly strip: string;
  readonly keyposes: string;
  /** Shown instead of figures when a clip has no keyposes. */
  readonly none: string;
  count(value: number): string;
  seconds(timeS: number, digits: number): string;
  /** "16 of 212 shown". */
  shown(shown: number, all: number): string;
  /** "Keypose 3 of 11, 2.82 seconds". */
  keypose(index: number, count: number, timeS: number): string;
}

export interface StripProps {
  readonly frames: number;
  readonly frameTimeS: number;
  readonly performer: PerformerResult;
  readonly keyposes: KeyposeResult | null;
  /** Poses of all keyposes: keyposes × joints × 3, world, file units; null while they are on their way. */
  readonly poses: Float32Array | null;
  readonly currentKeypose: number | null;
  readonly text: StripText;
}

export interface StripEvents {
  /** A keypose (index in time order) was chosen. */
  onPick(keypose: number): void;
}

const SVG_NAMESPACE = 'http://www.w3.org/2000/svg';
const STRIP_HEIGHT = 106;
const THREAD_HEIGHT = 14;
/** The common ground line of the figures. */
const GROUND_Y = 72;
/** Pixels from the strip's lower edge to the middle of the pins. */
const PIN_MIDDLE = 12;

export class KeyposeStrip {
  private readonly root = element('section', 'strip');
  private readonly area = element('div', 'strip-area');
  private readonly title = element('span', 'strip-title');
  private readonly number = element('strong', 'strip-count');
  private readonly remark = element('span', 'strip-remark');
  private readonly threads = document.createElementNS(SVG_NAMESPACE, 'svg');
  private readonly cards = element('div', 'strip-cards');
  private readonly observer: ResizeObserver;
  private buttons = new Map<number, HTMLButtonElement>();
  private threadOf = new Map<number, SVGPathElement>();
  private figures = new Map<number, FlatFigure>();

  constructor(
    target: HTMLElement,
    private props: StripProps,
    private readonly events: StripEvents,
  ) {
    const gutter = element('div', 'strip-gutter');
    gutter.append(this.title, this.number, this.remark);
    this.threads.setAttribute('class', 'strip-threads');
    this.threads.setAttribute('aria-hidden', 'true');
    this.cards.setAttribute('role', 'group');
    this.cards.addEventListener('keydown', (event) => this.walk(event));
    this.area.append(this.threads, this.cards);
    this.root.append(gutter, this.area);
    target.append(this.root);
    this.observer = new ResizeObserver(() => this.layout());
    this.observer.observe(this.area);
    this.layout();
  }

  /** Takes new properties and redraws what depends on them. */
  update(changes: Partial<StripProps>): void {
    const before = this.props;
    this.props = { ...before, ...changes };
    const placed = ['frames', 'keyposes', 'performer', 'poses', 'text'] as const;
    if (placed.some((key) => this.props[key] !== before[key])) this.layout();
    else if (this.props.currentKeypose !== before.currentKeypose) this.markCurrent();
  }

  destroy(): void {
    this.observer.disconnect();
    this.root.remove();
  }

  /** The figures of the cards alone: an hour of motion has thousands of keyposes. */
  private figuresOf(cards: readonly Card[]): Map<number, FlatFigure> {
    const { performer, poses } = this.props;
    const width = 3 * performer.skeleton.parents.length;
    const figures = new Map<number, FlatFigure>();
    for (const { keypose } of poses === null ? [] : cards) {
      const pose = poses!.subarray(keypose * width, (keypose + 1) * width);
      if (pose.length === width)
        figures.set(keypose, flatFigure(pose, performer, performer.sideYawRad));
    }
    return figures;
  }

  private layout(): void {
    const { frames, keyposes } = this.props;
    const axis = new Axis(
      Math.max(0, this.root.clientWidth - GUTTER_WIDTH),
      Math.max(0, frames - 1),
    );
    const at =
      keyposes === null ? [] : Array.from(keyposes.keyposes, (c) => keyposes.candidates[c]);
    const pinX = at.map((frame) => axis.x(frame));
    const { cards, cardWidth } = layoutStrip(pinX, intensitiesOf(keyposes), axis.width);
    this.writeGutter(cards.length, at.length);
    this.figures = this.figuresOf(cards);
    this.placeThreads(cards, pinX, axis.width);
    this.placeCards(cards, cardWidth, at);
    this.markCurrent();
  }

  private writeGutter(shown: number, all: number): void {
    const { text } = this.props;
    this.root.setAttribute('aria-label', text.strip);
    this.cards.setAttribute('aria-label', text.strip);
    this.title.textContent = text.keyposes;
    this.number.textContent = text.count(all);
    this.remark.textContent = all === 0 ? text.none : shown < all ? text.shown(shown, all) : '';
  }

  private placeCards(cards: readonly Card[], width: number, frames: readonly number[]): void {
    const focused = [...this.buttons].find(([, button]) => button === document.activeElement)?.[0];
    const scale = stripScale([...this.figures.values()], width);
    this.buttons = new Map(
      cards.map((card) => [card.keypose, this.card(card, width, scale, frames)]),
    );
    this.cards.replaceChildren(...this.buttons.values());
    if (focused !== undefined) this.buttons.get(focused)?.focus();
  }

  private card(
    card: Card,
    width: number,
    scale: number,
    frames: readonly number[],
  ): HTMLButtonElement {
    const { text, frameTimeS } = this.props;
    const timeS = frames[card.keypose] * frameTimeS;
    const button = element('button', 'keypose-card') as HTMLButtonElement;
    button.type = 'button';
    button.style.left = `${card.x - width / 2}px`;
    button.style.width = `${width - 1}px`;
    const label = cardLabel(text, card.keypose, timeS, width);
    const spoken = text.keypose(card.keypose + 1, frames.length, timeS);
    // The words seen stand in the name as they are, for those who speak to their computer.
    button.setAttribute('aria-label', `${label.textContent}, ${spoken}`);
    button.append(this.picture(card, width, scale), label);
    button.addEventListener('click', () => this.events.onPick(card.keypose));
    return button;
  }

  private picture(card: Card, width: number, scale: number): SVGSVGElement {
    const picture = document.createElementNS(SVG_NAMESPACE, 'svg');
    picture.setAttribute('aria-hidden', 'true');
    picture.setAttribute('width', String(width));
    picture.setAttribute('height', String(GROUND_Y + 8));
    const figure = this.figures.get(card.keypose);
    if (figure !== undefined) {
      const x = width / 2 - (scale * (figure.minX + figure.maxX)) / 2;
      drawFlatFigure(picture, figure, { scale, x, groundY: GROUND_Y });
    }
    return picture;
  }

  private placeThreads(cards: readonly Card[], pinX: readonly number[], width: number): void {
    const bottom = STRIP_HEIGHT + THREAD_HEIGHT + PIN_MIDDLE;
    this.threads.setAttribute('width', String(width));
    this.threads.setAttribute('height', String(bottom));
    const ground = document.createElementNS(SVG_NAMESPACE, 'path');
    ground.setAttribute('class', 'strip-ground');
    ground.setAttribute('d', `M0 ${GROUND_Y + 0.5}H${width}`);
    this.threadOf = new Map(
      cards.map((card) => [card.keypose, thread(card.x, pinX[card.keypose])]),
    );
    this.threads.replaceChildren(ground, ...this.threadOf.values());
  }

  private markCurrent(): void {
    const { currentKeypose } = this.props;
    const stop = this.buttons.has(currentKeypose ?? -1)
      ? currentKeypose
      : this.buttons.keys().next().value;
    for (const [keypose, button] of this.buttons) {
      const current = keypose === currentKeypose;
      button.classList.toggle('current', current);
      button.tabIndex = keypose === stop ? 0 : -1;
      if (current) button.setAttribute('aria-current', 'true');
      else button.removeAttribute('aria-current');
      this.threadOf.get(keypose)?.classList.toggle('current', current);
    }
  }

  /** ← → reach every keypose, shown or not. */
  private walk(event: KeyboardEvent): void {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (step === undefined || event.shiftKey) return;
    event.preventDefault();
    event.stopPropagation();
    const { currentKeypose, keyposes } = this.props;
    const last = (keyposes?.keyposes.length ?? 0) - 1;
    const next = Math.min(last, Math.max(0, (currentKeypose ?? 0) + step));
    this.events.onPick(next);
    this.buttons.get(next)?.focus();
  }
}

function intensitiesOf(keyposes: KeyposeResult | null): number[] {
  return keyposes === null ? [] : Array.from(keyposes.keyposes, (c) => keyposes.intensities[c]);
}

function thread(cardX: number, pinX: number): SVGPathElement {
  const path = document.createElementNS(SVG_NAMESPACE, 'path');
  const [top, bottom] = [STRIP_HEIGHT - 2, STRIP_HEIGHT + THREAD_HEIGHT + 6];
  path.setAttribute('class', 'thread');
  path.setAttribute(
    'd',
    `M${cardX} ${top}C${cardX} ${top + 15} ${pinX} ${top + 7} ${pinX} ${bottom}`,
  );
  return path;
}

function cardLabel(text: StripText, keypose: number, timeS: number, width: number): HTMLElement {
  const label = element('span', 'card-label');
  const number = element('b', 'card-number');
  number.textContent = text.count(keypose + 1);
  label.append(number, ` ${text.seconds(timeS, labelDigits(keypose + 1, timeS, width))}`);
  return label;
}
