/** The part of a clip that its rows show in; a thin bar that shows and moves it out, by pointer and by keys. */
import { element } from '../common/element';
import type { Axis } from '../timeline/axis';
import { brushWindow } from '../timeline/brush';

export interface SpanBarProps {
  /** The axis of the rows and that of the whole. */
  readonly shown: Axis;
  readonly whole: Axis;
  readonly label: string;
  /** "2.0 to 4.5 of 6.0 seconds". */
  readonly text: string;
}

export interface SpanBarEvents {
  /** By frames of the clip. */
  onPan(frames: number): void;
}

const NARROWEST = 24;
/** What an arrow key moves, in parts of the span. */
const KEY_STEP = 0.1;

export class SpanBar {
  readonly element = element('div', 'pair-span');
  private readonly thumb = element('i', 'pair-span-thumb');
  private props: SpanBarProps | null = null;

  constructor(private readonly events: SpanBarEvents) {
    const { element: bar } = this;
    bar.tabIndex = 0;
    bar.setAttribute('role', 'scrollbar');
    bar.setAttribute('aria-orientation', 'horizontal');
    bar.setAttribute('aria-valuemin', '0');
    bar.setAttribute('aria-valuemax', '100');
    bar.append(this.thumb);
    bar.addEventListener('pointerdown', (event) => this.grab(event));
    bar.addEventListener('pointermove', (event) => event.stopPropagation());
    bar.addEventListener('keydown', (event) => this.press(event));
  }

  update(props: SpanBarProps): void {
    this.props = props;
    const { whole, shown, label, text } = props;
    const { first, last } = brushWindow(shown.span, whole, NARROWEST);
    this.thumb.style.transform = `translateX(${first}px)`;
    this.thumb.style.width = `${last - first}px`;
    const room = lengthOf(whole) - lengthOf(shown);
    const part = room > 0 ? shown.span.first / room : 0;
    this.element.setAttribute('aria-valuenow', String(Math.round(100 * part)));
    this.element.setAttribute('aria-label', label);
    this.element.setAttribute('aria-valuetext', text);
  }

  private xOf({ clientX }: PointerEvent): number {
    return clientX - this.element.getBoundingClientRect().left;
  }

  /** A press beside the thumb brings its middle there; a drag takes it along. */
  private grab(event: PointerEvent): void {
    event.stopPropagation();
    if (event.button !== 0 || !this.props) return;
    const { element: bar } = this;
    const { shown, whole } = this.props;
    const x = this.xOf(event);
    const { first, last } = brushWindow(shown.span, whole, NARROWEST);
    if (x < first || x > last) this.moveTo(whole.placeAt(x) - lengthOf(shown) / 2);
    const held = whole.placeAt(x) - this.props.shown.span.first;
    bar.setPointerCapture(event.pointerId);
    const drag = (move: PointerEvent): void => this.moveTo(whole.placeAt(this.xOf(move)) - held);
    bar.addEventListener('pointermove', drag);
    bar.addEventListener('lostpointercapture', () => bar.removeEventListener('pointermove', drag), {
      once: true,
    });
  }

  private moveTo(first: number): void {
    if (this.props) this.events.onPan(first - this.props.shown.span.first);
  }

  private press(event: KeyboardEvent): void {
    if (!this.props || event.ctrlKey || event.metaKey || event.altKey || event.shiftKey) return;
    const { shown, whole } = this.props;
    const step = KEY_STEP * lengthOf(shown);
    const frames = {
      ArrowLeft: -step,
      ArrowRight: step,
      Home: -lengthOf(whole),
      End: lengthOf(whole),
    }[event.key];
    if (frames === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    this.events.onPan(frames);
  }
}

const lengthOf = ({ span }: Axis): number => span.last - span.first;
