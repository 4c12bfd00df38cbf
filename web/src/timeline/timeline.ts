/** The timeline of one clip: pins, ruler and motion speed on one axis, with playhead and hover. */
import './timeline.css';
import { element } from '../common/element';
import type { KeyposeResult } from '../engine/types';
import { Axis, GUTTER_WIDTH } from './axis';
import { layoutPins } from './pin-layout';
import { PinRow } from './pin-row';
import { Ruler } from './ruler';
import type { TimelineText } from './timeline-text';
import { drawSpeedRow, speedY } from './speed-row';

export interface TimelineProps {
  readonly frames: number;
  readonly frameTimeS: number;
  readonly leadingRestFrames: number;
  readonly keyposes: KeyposeResult | null;
  /** Index of the current keypose in time order; null without keyposes. */
  readonly currentKeypose: number | null;
  readonly frame: number;
  /** The moment under the pointer anywhere on the page. */
  readonly hoverFrame: number | null;
  /** Redraws the colours when it changes. */
  readonly theme: string;
  readonly text: TimelineText;
}

export interface TimelineEvents {
  onSeek(frame: number): void;
  onHover(frame: number | null): void;
}

export class Timeline {
  private readonly root = element('section', 'timeline');
  private readonly area = element('div', 'timeline-area');
  private readonly canvas = document.createElement('canvas');
  private readonly rest = element('div', 'timeline-rest');
  private readonly stems = element('div', 'timeline-stems');
  private readonly playhead = element('div', 'playhead');
  private readonly flag = element('div', 'playhead-flag');
  private readonly hover = element('div', 'hover-line');
  private readonly hoverFlag = element('div', 'hover-flag');
  private readonly maximum = element('span', 'timeline-maximum');
  private readonly speedValue = element('span', 'timeline-value');
  private readonly labels: Record<
    'pins' | 'time' | 'timeUnits' | 'speed' | 'speedUnit',
    HTMLElement
  >;
  private readonly pins: PinRow;
  private readonly ruler = new Ruler();
  private readonly observer: ResizeObserver;
  private axis = new Axis(0, 0);

  constructor(
    target: HTMLElement,
    private props: TimelineProps,
    private readonly events: TimelineEvents,
  ) {
    this.pins = new PinRow((keypose) => this.seekKeypose(keypose));
    this.labels = this.buildGutter();
    this.buildArea();
    target.append(this.root);
    this.listen();
    this.observer = new ResizeObserver(() => this.layout());
    this.observer.observe(this.area);
    this.layout();
  }

  /** Takes new properties and redraws what depends on them. */
  update(changes: Partial<TimelineProps>): void {
    const before = this.props;
    this.props = { ...before, ...changes };
    const still = [
      'frames',
      'frameTimeS',
      'keyposes',
      'leadingRestFrames',
      'theme',
      'text',
    ] as const;
    if (still.some((key) => this.props[key] !== before[key])) this.layout();
    else this.move(before);
  }

  destroy(): void {
    this.observer.disconnect();
    this.root.remove();
  }

  private buildGutter(): Timeline['labels'] {
    const gutter = element('div', 'timeline-gutter');
    const labels = {
      pins: element('span', 'timeline-label pins-label'),
      time: element('span', 'timeline-label time-label'),
      timeUnits: element('span', 'timeline-label time-units'),
      speed: element('span', 'timeline-label speed-label'),
      speedUnit: element('span', 'timeline-label speed-unit'),
    };
    gutter.append(...Object.values(labels), this.speedValue);
    this.root.append(gutter, this.area);
    return labels;
  }

  private buildArea(): void {
    this.canvas.className = 'speed-row';
    this.canvas.setAttribute('aria-hidden', 'true');
    this.playhead.append(this.flag);
    this.hover.append(this.hoverFlag);
    this.playhead.tabIndex = 0;
    this.playhead.setAttribute('role', 'slider');
    this.playhead.setAttribute('aria-valuemin', '0');
    this.area.append(this.rest, this.ruler.element, this.canvas, this.stems, this.maximum);
    this.area.append(this.pins.element, this.hover, this.playhead);
  }

  private layout(): void {
    const { frames, frameTimeS, leadingRestFrames, text } = this.props;
    const width = Math.max(0, this.root.clientWidth - GUTTER_WIDTH);
    this.axis = new Axis(width, Math.max(0, frames - 1));
    this.writeLabels();
    this.rest.style.width = `${leadingRestFrames > 0 ? this.axis.x(leadingRestFrames) : 0}px`;
    this.ruler.update(this.axis, frameTimeS, text);
    this.layoutKeyposes();
    this.move(null);
  }

  private writeLabels(): void {
    const { text, keyposes } = this.props;
    for (const key of Object.keys(this.labels) as (keyof Timeline['labels'])[]) {
      this.labels[key].textContent = text[key];
    }
    this.root.setAttribute('aria-label', text.timeline);
    this.playhead.setAttribute('aria-label', text.playhead);
    this.playhead.setAttribute('aria-valuemax', String(this.axis.lastFrame));
    this.maximum.textContent = keyposes === null ? '' : text.speedValue(keyposes.maximumSpeed);
  }

  private layoutKeyposes(): void {
    const { keyposes, text, frameTimeS } = this.props;
    this.canvas.hidden = keyposes === null;
    if (keyposes !== null) drawSpeedRow(this.canvas, this.axis, keyposes);
    const frames = keyposes === null ? new Int32Array() : keyposeFrames(keyposes);
    const pins = layoutPins(frames, this.axis);
    this.pins.update(pins, frames, frameTimeS, text);
    this.stems.replaceChildren(...pins.flatMap((pin) => this.stem(pin.x, frames[pin.first])));
  }

  private stem(x: number, frame: number): HTMLElement[] {
    const keyposes = this.props.keyposes!;
    const stem = element('i', 'stem');
    const dot = element('i', 'stem-dot');
    const speed = keyposes.speed[frame - keyposes.firstFrame] ?? 0;
    stem.style.left = dot.style.left = `${x}px`;
    dot.style.top = `${PIN_AND_RULER_HEIGHT + speedY(speed, keyposes.maximumSpeed)}px`;
    return [stem, dot];
  }

  /** Moves what follows the time; everything when `before` is null. */
  private move(before: TimelineProps | null): void {
    const { frame, hoverFrame, currentKeypose } = this.props;
    if (before === null || frame !== before.frame) this.movePlayhead();
    if (before === null || hoverFrame !== before.hoverFrame) this.moveHover();
    if (before === null || currentKeypose !== before.currentKeypose) this.markCurrent();
    this.writeSpeed();
  }

  private movePlayhead(): void {
    const { frame, frameTimeS, text } = this.props;
    this.place(this.playhead, this.flag, frame);
    this.flag.textContent = text.seconds(frame * frameTimeS, 3);
    this.playhead.setAttribute('aria-valuenow', String(frame));
    this.playhead.setAttribute('aria-valuetext', text.moment(frame, frame * frameTimeS));
    this.ruler.makeRoom(this.axis.x(frame));
  }

  private moveHover(): void {
    const { hoverFrame, frameTimeS, text } = this.props;
    this.hover.hidden = hoverFrame === null;
    if (hoverFrame === null) return;
    this.place(this.hover, this.hoverFlag, hoverFrame);
    this.hoverFlag.textContent = text.seconds(hoverFrame * frameTimeS, 3);
  }

  /** Puts a line at a frame; its flag stays within the axis. */
  private place(line: HTMLElement, flag: HTMLElement, frame: number): void {
    const x = this.axis.x(frame);
    const inside = Math.min(this.axis.width - FLAG_HALF_WIDTH, Math.max(FLAG_HALF_WIDTH, x));
    line.style.transform = `translateX(${x}px)`;
    flag.style.marginLeft = `${inside - x}px`;
  }

  private markCurrent(): void {
    this.pins.markCurrent(this.props.currentKeypose);
    const current = this.pins.currentPin;
    const stems = this.stems.children;
    for (let index = 0; index < stems.length; index++) {
      stems[index].classList.toggle('current', Math.floor(index / 2) === current);
    }
  }

  private writeSpeed(): void {
    const { keyposes, frame, hoverFrame, text } = this.props;
    const speed = keyposes?.speed[(hoverFrame ?? frame) - keyposes.firstFrame];
    this.speedValue.textContent = speed === undefined ? '' : text.speedValue(speed);
  }

  private seekKeypose(keypose: number): void {
    const { keyposes } = this.props;
    if (keyposes !== null) this.events.onSeek(keyposeFrames(keyposes)[keypose]);
  }

  private listen(): void {
    const frameOf = (event: PointerEvent): number =>
      this.axis.frameAt(event.clientX - this.area.getBoundingClientRect().left);
    this.area.addEventListener('pointerdown', (event) => {
      if (event.button !== 0 || event.target instanceof HTMLButtonElement) return;
      this.area.setPointerCapture(event.pointerId);
      this.events.onSeek(frameOf(event));
    });
    this.area.addEventListener('pointermove', (event) => {
      if (this.area.hasPointerCapture(event.pointerId)) this.events.onSeek(frameOf(event));
      else this.events.onHover(frameOf(event));
    });
    this.area.addEventListener('pointerleave', () => this.events.onHover(null));
  }
}

const PIN_AND_RULER_HEIGHT = 46;
/** Half the width of a time flag and a little air, in pixels. */
const FLAG_HALF_WIDTH = 26;

/** The frames of the keyposes, in time order. */
export function keyposeFrames(keyposes: KeyposeResult): Int32Array {
  return keyposes.keyposes.map((candidate) => keyposes.candidates[candidate]);
}
