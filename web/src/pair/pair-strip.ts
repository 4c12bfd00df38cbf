/** Keyposes of one clip and their poses in; a row of small figures over their moments out, buttons with one tab stop. */
import { element } from '../common/element';
import type { PerformerResult } from '../engine/types';
import { drawFlatFigure } from '../figure/draw-flat-figure';
import { type FlatFigure, flatFigure } from '../figure/flat-figure';
import { placed } from '../figure/placement';
import {
  labelDigits,
  layoutStrip,
  leastLabelWidth,
  SMALLEST_CARD,
  type StripLayout,
  stripScale,
} from '../strip/strip-layout';
import type { Axis } from '../timeline/axis';
import { within } from '../timeline/sorted';
import { svgElement } from './svg-element';

export interface PairStripProps {
  readonly axis: Axis;
  readonly frameTimeS: number;
  readonly performer: PerformerResult;
  /** From where the figures are seen. */
  readonly yawRad: number;
  /** Left and right change places. */
  readonly mirrored: boolean;
  readonly keyposes: Int32Array;
  readonly poses: ReadonlyMap<number, Float32Array>;
  readonly current: number | null;
  readonly label: string;
  /** Spoken name of a keypose. */
  readonly keyposeName: (number: number, count: number, timeS: number) => string;
}

export interface PairStripEvents {
  onPick(keypose: number): void;
  onHover(frame: number | null): void;
  /** Frames whose poses are needed. */
  onShown(frames: Int32Array): void;
}

const GROUND_Y = 55;
/** The figures of the study's strip are so much larger. */
const SCALE = 0.8;

interface Card {
  readonly button: HTMLButtonElement;
  readonly picture: SVGSVGElement;
  readonly number: HTMLElement;
  readonly seconds: Text;
  drawn: string;
}

export class PairStrip {
  private readonly root = element('div', 'pair-cards');
  private readonly cards = new Map<number, Card>();
  private figures = new Map<number, FlatFigure>();
  private figuresOf: unknown = null;
  private seen = '';
  private props: PairStripProps | null = null;

  constructor(
    target: HTMLElement,
    private readonly events: PairStripEvents,
  ) {
    this.root.setAttribute('role', 'group');
    target.append(this.root);
    this.root.addEventListener('click', (event) => this.click(event));
    this.root.addEventListener('keydown', (event) => this.walk(event));
    this.root.addEventListener('pointerover', ({ target: over }) => {
      const keypose = keyposeOf(over);
      this.events.onHover(keypose === null ? null : (this.props?.keyposes[keypose] ?? null));
    });
    this.root.addEventListener('pointerleave', () => this.events.onHover(null));
  }

  update(props: PairStripProps): void {
    this.props = props;
    this.forgetFigures(props);
    this.root.setAttribute('aria-label', props.label);
    const { cards, cardWidth } = layoutOf(props);
    this.events.onShown(Int32Array.from(cards, ({ keypose }) => props.keyposes[keypose]));
    this.remove(new Set(cards.map(({ keypose }) => keypose)));
    const figures = cards.map(({ keypose }) => this.figureOf(keypose, props));
    const known = figures.filter((figure) => figure !== null);
    const scale = SCALE * stripScale(known, cardWidth);
    const digits = digitsOf(cards, cardWidth, props);
    cards.forEach(({ keypose, x }, i) => {
      const card = this.cardOf(keypose);
      card.button.style.transform = `translateX(${x - cardWidth / 2}px)`;
      card.button.style.width = `${cardWidth - 1}px`;
      this.label(card, keypose, digits, props);
      draw(card, figures[i], scale);
    });
  }

  /** Those of another clip, or seen from elsewhere. */
  private forgetFigures({ performer, yawRad, mirrored }: PairStripProps): void {
    const seen = `${yawRad} ${mirrored}`;
    if (this.figuresOf !== performer || this.seen !== seen) this.figures.clear();
    this.figuresOf = performer;
    this.seen = seen;
  }

  private label(card: Card, keypose: number, digits: number, props: PairStripProps): void {
    const { keyposes, current, frameTimeS, keyposeName } = props;
    const timeS = keyposes[keypose] * frameTimeS;
    const seconds = timeS.toFixed(digits);
    const isCurrent = keypose === current;
    card.number.textContent = String(keypose + 1);
    card.seconds.data = ` ${seconds}`;
    const spoken = keyposeName(keypose + 1, keyposes.length, timeS);
    card.button.setAttribute('aria-label', `${keypose + 1} ${seconds}, ${spoken}`);
    card.button.classList.toggle('current', isCurrent);
    card.button.tabIndex = isCurrent || (current === null && keypose === 0) ? 0 : -1;
    if (isCurrent) card.button.setAttribute('aria-current', 'true');
    else card.button.removeAttribute('aria-current');
  }

  private figureOf(keypose: number, props: PairStripProps): FlatFigure | null {
    const { performer, poses, yawRad, keyposes, mirrored } = props;
    const known = this.figures.get(keypose);
    const pose = known ? undefined : poses.get(keyposes[keypose]);
    if (pose === undefined) return known ?? null;
    const stand = { x: 0, z: 0, yawRad: performer.frontYawRad };
    const placement = mirrored ? placed(stand, stand, true) : undefined;
    const figure = flatFigure(pose, performer, yawRad, placement);
    this.figures.set(keypose, figure);
    return figure;
  }

  private cardOf(keypose: number): Card {
    const known = this.cards.get(keypose);
    if (known) return known;
    const button = element('button', 'pair-card') as HTMLButtonElement;
    button.type = 'button';
    button.dataset['keypose'] = String(keypose);
    const picture = svgElement('svg');
    picture.setAttribute('aria-hidden', 'true');
    const label = element('span', 'card-label');
    const number = element('b', 'card-number');
    const seconds = document.createTextNode('');
    label.append(number, seconds);
    button.append(picture, label);
    const card: Card = { button, picture, number, seconds, drawn: '' };
    this.cards.set(keypose, card);
    const after = [...this.cards.keys()]
      .filter((other) => other > keypose)
      .sort((a, b) => a - b)[0];
    this.root.insertBefore(button, after === undefined ? null : this.cards.get(after)!.button);
    return card;
  }

  private remove(shown: ReadonlySet<number>): void {
    for (const [keypose, { button }] of this.cards) {
      if (shown.has(keypose) && keypose < (this.props?.keyposes.length ?? 0)) continue;
      button.remove();
      this.cards.delete(keypose);
    }
  }

  private click({ target }: Event): void {
    const keypose = keyposeOf(target);
    if (keypose !== null) this.events.onPick(keypose);
  }

  /** ← → go from keypose to keypose, shown or not. */
  private walk(event: KeyboardEvent): void {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    const from = keyposeOf(event.target);
    const count = this.props?.keyposes.length ?? 0;
    if (step === undefined || from === null || event.shiftKey || count === 0) return;
    event.preventDefault();
    event.stopPropagation();
    const next = Math.min(count - 1, Math.max(0, from + step));
    this.events.onPick(next);
    if (this.props) this.update({ ...this.props, current: next });
    this.cards.get(next)?.button.focus();
  }
}

function layoutOf({ axis, keyposes, current, frameTimeS, performer }: PairStripProps): StripLayout {
  const lastS = (keyposes.at(-1) ?? 0) * frameTimeS;
  const { from, to } = within(keyposes, axis.span.first, axis.span.last);
  const places = Array.from(keyposes, (frame) => axis.x(frame));
  return layoutStrip(places, intensitiesOf(performer), {
    first: from,
    end: to,
    kept: current,
    width: axis.width,
    leastCard: Math.max(SMALLEST_CARD, leastLabelWidth(keyposes.length, lastS)),
  });
}

/** Decimals for which every card has room. */
function digitsOf(
  cards: StripLayout['cards'],
  cardWidth: number,
  { keyposes, frameTimeS }: PairStripProps,
): number {
  const all = cards.map(({ keypose }) =>
    labelDigits(keypose + 1, keyposes[keypose] * frameTimeS, cardWidth),
  );
  return Math.min(...all);
}

function draw(card: Card, figure: FlatFigure | null, scale: number): void {
  const key = figure === null ? '' : `${scale} ${figure.minX} ${figure.maxX} ${figure.maxY}`;
  if (key === card.drawn) return;
  card.drawn = key;
  card.picture.replaceChildren();
  if (figure === null) return;
  const x = (-scale * (figure.minX + figure.maxX)) / 2;
  drawFlatFigure(card.picture, figure, { scale, x, groundY: GROUND_Y });
}

function keyposeOf(target: EventTarget | null): number | null {
  const card = target instanceof Element ? target.closest<HTMLElement>('.pair-card') : null;
  return card === null ? null : Number(card.dataset['keypose']);
}

function intensitiesOf({ keyposes }: PerformerResult): number[] {
  return Array.from(keyposes?.keyposes ?? [], (candidate) => keyposes!.intensities[candidate]);
}
