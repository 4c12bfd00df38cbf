/** The overview: the whole clip's speed, and on it the part that the other rows show, as a brush. */
import { element } from '../common/element';
import { Axis, type AxisSpan } from './axis';
import {
  brushed,
  brushPart,
  brushWindow,
  NARROWEST_WITH_EDGES,
  spanAfterKey,
  type BrushPart,
} from './brush';
import { prepareCanvas } from './canvas';
import type { Palette } from './palette';
import type { Row } from './rows';
import { curveOf } from './speed-curve';
import type { TimelineData } from './timeline-data';
import type { TimelineText } from './timeline-text';
import { panned, wholeSpan } from './zoom';

export interface OverviewEvents {
  /** Another part is to be shown; null: all of it. */
  onZoom(span: AxisSpan | null): void;
}

const NARROWEST_WINDOW = 8;
const FOOT = 3;
const AIR = 6;
/** A press that moves less than this is no drag, in pixels. */
const DRAG_START = 4;

export class Overview {
  readonly element = element('div', 'overview');
  private readonly canvas = document.createElement('canvas');
  private readonly window = element('div', 'overview-window');
  private readonly playhead = element('i', 'overview-playhead');
  private axis = new Axis(0, 0);
  private span: AxisSpan = { first: 0, last: 0 };

  constructor(private readonly events: OverviewEvents) {
    this.canvas.setAttribute('aria-hidden', 'true');
    this.window.tabIndex = 0;
    this.window.setAttribute('role', 'slider');
    this.window.setAttribute('aria-valuemin', '0');
    this.window.append(element('i', 'overview-edge first'), element('i', 'overview-edge last'));
    this.element.append(this.canvas, this.playhead, this.window);
    this.element.addEventListener('pointerdown', (event) => this.grab(event));
    this.element.addEventListener('pointermove', (event) => this.pointAt(event));
    this.element.addEventListener('dblclick', () => this.zoom(null));
    this.window.addEventListener('keydown', (event) => this.press(event));
  }

  /** Draws the speed of the whole clip. */
  draw(
    width: number,
    lastFrame: number,
    row: Row,
    data: TimelineData | null,
    palette: Palette,
  ): void {
    this.axis = new Axis(width, lastFrame);
    this.element.style.top = `${row.top}px`;
    const context = prepareCanvas(this.canvas, width, row.height);
    if (context !== null && data !== null) drawArea(context, this.axis, row, data, palette);
  }

  update(span: AxisSpan, frameTimeS: number, text: TimelineText): void {
    this.span = span;
    const { first, last } = brushWindow(span, this.axis, NARROWEST_WINDOW);
    this.window.style.transform = `translateX(${first}px)`;
    this.window.style.width = `${last - first}px`;
    this.window.classList.toggle('whole', this.isWhole);
    this.window.classList.toggle('narrow', last - first < NARROWEST_WITH_EDGES);
    this.window.setAttribute('aria-label', text.overview);
    this.window.setAttribute('aria-valuemax', String(this.axis.lastFrame));
    this.window.setAttribute('aria-valuenow', String(Math.round(span.first)));
    const { lastFrame } = this.axis;
    const shown = text.shown(
      span.first * frameTimeS,
      span.last * frameTimeS,
      lastFrame * frameTimeS,
    );
    this.window.setAttribute('aria-valuetext', shown);
  }

  /** Whether an element is a part of the overview. */
  holds(target: EventTarget | null): boolean {
    return target instanceof Node && this.element.contains(target);
  }

  frameAt(x: number): number {
    return this.axis.frameAt(x);
  }

  movePlayhead(frame: number): void {
    this.playhead.style.transform = `translateX(${this.axis.x(frame)}px)`;
  }

  /** Keys may come faster than the page draws: they go on from here. */
  private zoom(span: AxisSpan | null): void {
    this.span = span ?? wholeSpan(this.axis.lastFrame);
    this.events.onZoom(span);
  }

  private get isWhole(): boolean {
    return this.span.last - this.span.first >= this.axis.lastFrame;
  }

  private xOf({ clientX }: PointerEvent): number {
    return clientX - this.element.getBoundingClientRect().left;
  }

  private partAt(x: number): BrushPart {
    return brushPart(brushWindow(this.span, this.axis, NARROWEST_WINDOW), x, this.isWhole);
  }

  /** The pointer tells what a press would take hold of. */
  private pointAt(event: PointerEvent): void {
    if (event.buttons === 0) this.element.dataset['part'] = this.partAt(this.xOf(event));
  }

  private grab(event: PointerEvent): void {
    event.stopPropagation();
    if (event.button !== 0) return;
    const from = this.xOf(event);
    const part = this.partAt(from);
    const span = this.span;
    let dragged = false;
    this.element.setPointerCapture(event.pointerId);
    const drag = (move: PointerEvent): void => {
      const x = this.xOf(move);
      dragged ||= Math.abs(x - from) >= DRAG_START;
      if (dragged) this.zoom(brushed(part, span, this.axis, from, x));
    };
    const drop = (): void => {
      this.element.removeEventListener('pointermove', drag);
      this.element.removeEventListener('lostpointercapture', drop);
      if (!dragged && part === 'outside' && !this.isWhole) this.centre(from);
    };
    this.element.addEventListener('pointermove', drag);
    this.element.addEventListener('lostpointercapture', drop);
  }

  /** A press beside the window brings the window there. */
  private centre(x: number): void {
    const middle = (this.span.first + this.span.last) / 2;
    this.zoom(panned(this.span, this.axis.lastFrame, this.axis.placeAt(x) - middle));
  }

  private press(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const span = spanAfterKey(event.key, event.shiftKey, this.span, this.axis.lastFrame);
    if (span === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    this.zoom(span);
  }
}

function drawArea(
  context: CanvasRenderingContext2D,
  axis: Axis,
  row: Row,
  data: TimelineData,
  palette: Palette,
): void {
  const { x, maximum } = curveOf(data.speed, data.result.firstFrame, axis);
  if (x.length === 0) return;
  const base = row.height - FOOT;
  const scale = data.result.maximumSpeed > 0 ? (row.height - AIR) / data.result.maximumSpeed : 0;
  context.beginPath();
  context.moveTo(x[0], base);
  for (let index = 0; index < x.length; index++)
    context.lineTo(x[index], base - maximum[index] * scale);
  context.lineTo(x[x.length - 1], base);
  context.fillStyle = palette.line2;
  context.fill();
}
