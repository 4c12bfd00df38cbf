/** The timeline of one clip: rows on one axis that can be zoomed, with playhead, hover, loop and overview. */
import './timeline.css';
import type { FoldableRow } from '../app/store';
import { element } from '../common/element';
import type { KeyposeResult } from '../engine/types';
import type { LoopRange } from '../player/clock';
import { Axis, GUTTER_WIDTH, type AxisSpan } from './axis';
import { watchPixelRatio } from './canvas';
import { Gestures, type GestureGround } from './gestures';
import { Gutter } from './gutter';
import { candidateAt } from './hit';
import { LoopBand } from './loop-band';
import { Overview } from './overview';
import { paletteOf, type Palette } from './palette';
import { layoutPins } from './pin-layout';
import { PinRow } from './pin-row';
import { Playhead } from './playhead';
import { RowLabels } from './row-labels';
import { layoutRows, rowAt, type RowLayout } from './rows';
import { RowsCanvas } from './rows-canvas';
import { Ruler } from './ruler';
import { divisionOf, rulerTicks } from './ruler-layout';
import type { ScaleRange } from './scale-axis';
import { sceneOf, type Scene } from './scene';
import { TimelineData } from './timeline-data';
import type { TimelineText } from './timeline-text';
import { fitted, wholeSpan } from './zoom';

export interface TimelineProps {
  readonly frames: number;
  readonly frameTimeS: number;
  readonly leadingRestFrames: number;
  readonly keyposes: KeyposeResult | null;
  /** The scales to show; null while the parameters are not known. */
  readonly scaleRange: ScaleRange | null;
  /** Why there are no keyposes, in a sentence. */
  readonly reason: string;
  /** A newer result is on its way. */
  readonly outdated: boolean;
  /** Index of the current keypose in time order; null without keyposes. */
  readonly currentKeypose: number | null;
  readonly frame: number;
  /** The moment under the pointer anywhere on the page. */
  readonly hoverFrame: number | null;
  /** The frames shown. */
  readonly span: AxisSpan;
  readonly folded: ReadonlySet<FoldableRow>;
  readonly loop: LoopRange | null;
  readonly looping: boolean;
  /** Redraws the colours when it changes. */
  readonly theme: string;
  readonly text: TimelineText;
}

export interface TimelineEvents {
  onSeek(frame: number): void;
  onHover(frame: number | null): void;
  /** Another part of the clip is to be shown; null: all of it. */
  onZoom(span: AxisSpan | null): void;
  onFold(row: FoldableRow, folded: boolean): void;
  onLoop(range: LoopRange | null): void;
}

/** Properties upon which everything is laid out anew; upon those of `SPAN` the rows are drawn anew. */
const STILL = [
  'frames',
  'frameTimeS',
  'keyposes',
  'theme',
  'text',
  'folded',
  'reason',
  'scaleRange',
] as const;
const SPAN = ['span', 'leadingRestFrames'] as const;
/** Frames from which on a result is made ready in slices, and the longest slice. */
const LONG = 20_000;
const BUILD_MS = 10;
/** Air around the keyposes of a lozenge that is opened, in parts of their length and in frames. */
const OPEN_AIR = 0.15;
const OPEN_FRAMES = 10;

export class Timeline {
  private readonly root = element('section', 'timeline');
  private readonly area = element('div', 'timeline-area');
  private readonly layer = element('div', 'timeline-layer');
  private readonly rest = element('div', 'timeline-rest');
  private readonly reason = element('p', 'timeline-reason');
  private readonly gutter: Gutter;
  private readonly canvases = new RowsCanvas();
  private readonly labels = new RowLabels();
  private readonly ruler = new Ruler();
  private readonly pins: PinRow;
  private readonly playhead = new Playhead();
  private readonly loop: LoopBand;
  private readonly overview: Overview;
  private readonly stops: (() => void)[] = [];
  private axis = new Axis(0, 0);
  private rows: RowLayout = layoutRows(new Set(), true);
  /** What `data` was, or is just being, made of. */
  private source: KeyposeResult | null = null;
  private data: TimelineData | null = null;
  private scene: Scene | null = null;
  private palette: Palette | null = null;

  constructor(
    target: HTMLElement,
    private props: TimelineProps,
    private readonly events: TimelineEvents,
  ) {
    this.gutter = new Gutter((row, folded) => this.events.onFold(row, folded));
    this.pins = new PinRow({
      onPick: (keypose) => this.events.onSeek(this.data?.frames[keypose] ?? 0),
      onOpen: (first, last) => this.open(first, last),
    });
    this.loop = new LoopBand({ onLoop: (range) => this.events.onLoop(range) });
    this.overview = new Overview({ onZoom: (span) => this.zoom(span) });
    this.build();
    target.append(this.root);
    this.listen();
    this.layout();
  }

  /** Takes new properties and redraws what depends on them. */
  update(changes: Partial<TimelineProps>): void {
    const before = this.props;
    this.props = { ...before, ...changes };
    const changed = (key: keyof TimelineProps): boolean => this.props[key] !== before[key];
    if (changed('outdated')) this.root.classList.toggle('outdated', this.props.outdated);
    if (STILL.some(changed)) this.layout();
    else if (SPAN.some(changed)) this.show();
    else this.follow(before);
  }

  destroy(): void {
    for (const stop of this.stops) stop();
    this.root.remove();
  }

  private build(): void {
    this.layer.append(
      this.rest,
      this.loop.band,
      this.canvases.still,
      this.canvases.current,
      this.labels.element,
      this.ruler.element,
      this.reason,
      this.pins.element,
      this.playhead.twin,
      this.loop.tabs.a,
      this.loop.tabs.b,
      this.playhead.line,
    );
    this.area.append(this.layer, this.overview.element);
    this.root.append(this.gutter.element, this.area);
    this.root.classList.toggle('outdated', this.props.outdated);
  }

  private layout(): void {
    const { keyposes, folded, frames, text, reason } = this.props;
    if (this.source !== keyposes) this.prepare();
    this.rows = layoutRows(folded, keyposes !== null);
    this.palette = paletteOf(this.root);
    this.root.style.height = `${this.rows.height + 1}px`;
    this.layer.style.height = `${this.rows.spanHeight}px`;
    this.root.setAttribute('aria-label', text.timeline);
    this.reason.textContent = reason;
    this.reason.hidden = keyposes !== null;
    this.gutter.update(this.rows, text, keyposes !== null);
    this.labels.update(this.rows, this.data, this.props.scaleRange, text);
    this.overview.draw(
      this.width,
      Math.max(0, frames - 1),
      this.rows.overview,
      this.data,
      this.palette,
    );
    this.show();
  }

  /** Draws the span that is shown. */
  private show(): void {
    const { frames, frameTimeS, span, scaleRange, text } = this.props;
    this.axis = new Axis(this.width, Math.max(0, frames - 1), span);
    const { axis, rows, data } = this;
    const palette = this.palette!;
    const division = divisionOf(axis, frameTimeS);
    const ticks = axis.width > 0 ? rulerTicks(axis, frameTimeS, division) : [];
    this.scene = data === null ? null : sceneOf(axis, rows, data, palette, scaleRange);
    this.canvases.draw(axis, rows, palette, ticks, this.scene);
    this.ruler.update(axis, frameTimeS, ticks, division, text);
    const keyposeFrames = data?.frames ?? new Int32Array();
    this.pins.update(layoutPins(keyposeFrames, axis), axis, keyposeFrames, frameTimeS, text);
    this.playhead.update(axis, text);
    this.overview.update(span, frameTimeS, text);
    this.placeRest();
    this.follow(null);
  }

  private placeRest(): void {
    const [left, right] = [this.axis.x(0), this.axis.x(this.props.leadingRestFrames)];
    const from = Math.max(0, this.props.span.first > 0 ? left : 0);
    this.rest.style.left = `${from}px`;
    this.rest.style.width = `${Math.max(0, Math.min(this.axis.width, right) - from)}px`;
    this.rest.style.height = `${this.rows.spanHeight - this.rows.ruler.top}px`;
    this.rest.hidden = this.props.leadingRestFrames === 0;
  }

  /** Moves what follows the time; everything when `before` is null. */
  private follow(before: TimelineProps | null): void {
    const { frame, frameTimeS, hoverFrame, loop, looping, text } = this.props;
    const changed = (key: keyof TimelineProps): boolean =>
      before === null || this.props[key] !== before[key];
    if (changed('frame')) {
      this.playhead.move(this.axis, frame, frameTimeS, text);
      this.overview.movePlayhead(frame);
    }
    if (changed('hoverFrame')) this.playhead.moveTwin(this.axis, hoverFrame, frameTimeS, text);
    if (changed('currentKeypose')) this.markCurrent();
    if (changed('loop') || changed('looping'))
      this.loop.update(this.axis, this.rows, loop, looping, frameTimeS, text);
    if (changed('frame') || changed('loop') || changed('hoverFrame')) this.makeRoom();
    this.writeFigures();
  }

  private markCurrent(): void {
    const { currentKeypose } = this.props;
    this.pins.markCurrent(currentKeypose);
    this.canvases.drawCurrent(this.axis, this.rows, this.scene, currentKeypose);
  }

  private makeRoom(): void {
    const { frame, hoverFrame, loop } = this.props;
    const frames = [frame, hoverFrame ?? frame, loop?.a ?? frame, loop?.b ?? frame];
    this.ruler.makeRoom(frames.map((place) => this.axis.x(place)));
  }

  private writeFigures(): void {
    const { frame, hoverFrame, span, frames, frameTimeS, text } = this.props;
    const speed = this.data?.speedAt(hoverFrame ?? frame);
    const cut = this.data?.result.cut ?? null;
    const length = span.last - span.first;
    this.gutter.showFigures({
      speed: speed === undefined ? '' : text.figure(speed),
      intensity: cut === null ? '' : text.figure(cut),
      overview: length < frames - 1 ? text.withUnit(text.seconds(length * frameTimeS, 1)) : '',
    });
  }

  private get width(): number {
    return Math.max(0, this.root.clientWidth - GUTTER_WIDTH);
  }

  /** Shows the keyposes of a lozenge apart. */
  private open(first: number, last: number): void {
    if (this.data === null) return;
    const [from, to] = [this.data.frames[first], this.data.frames[last]];
    const air = Math.max(OPEN_FRAMES, OPEN_AIR * (to - from));
    this.zoom(fitted({ first: from - air, last: to + air }, this.axis.lastFrame));
  }

  /** Other wheels may turn before the page draws: they go on from here. */
  private zoom(span: AxisSpan | null): void {
    this.axis = new Axis(
      this.axis.width,
      this.axis.lastFrame,
      span ?? wholeSpan(this.axis.lastFrame),
    );
    this.events.onZoom(span);
  }

  /** Makes ready to draw another result: at once, or slice by slice where it is long. */
  private prepare(): void {
    const { keyposes } = this.props;
    const before = this.source;
    this.source = keyposes;
    const isLong = keyposes !== null && keyposes.speed.length > LONG;
    // While a new result of the same clip is made ready, the old one stays.
    if (before?.speed.length !== keyposes?.speed.length || !isLong) this.data = null;
    if (!isLong) this.data = keyposes && new TimelineData(keyposes);
    else requestAnimationFrame(() => this.buildSlice(keyposes, null));
  }

  private buildSlice(keyposes: KeyposeResult, begun: TimelineData | null): void {
    if (this.source !== keyposes) return;
    const data = begun ?? new TimelineData(keyposes);
    const isReady = begun !== null && data.build(BUILD_MS);
    // What is ready is drawn in the next frame, so that no frame does both.
    requestAnimationFrame(() => {
      if (isReady) this.take(data);
      else this.buildSlice(keyposes, data);
    });
  }

  private take(data: TimelineData): void {
    if (this.source !== data.result) return;
    this.data = data;
    this.layout();
  }

  private get ground(): GestureGround {
    return {
      axis: () => this.axis,
      frameAt: (x, target) =>
        this.overview.holds(target) ? this.overview.frameAt(x) : this.axis.frameAt(x),
      isRuler: (y) => rowAt(this.rows, y) === 'ruler',
      momentAt: (x, y, target) =>
        this.pins.frameOf(target) ?? (this.scene && candidateAt(this.scene, x, y)),
    };
  }

  private listen(): void {
    const { events } = this;
    new Gestures(this.area, this.ground, {
      onSeek: (frame) => events.onSeek(frame),
      onHover: (frame) => events.onHover(frame),
      onLoop: (range) => events.onLoop(range),
      onZoom: (span) => this.zoom(span),
    });
    this.area.addEventListener('dblclick', (event) => {
      const x = event.clientX - this.area.getBoundingClientRect().left;
      if (this.loop.covers(x) && !(event.target instanceof HTMLButtonElement)) events.onLoop(null);
    });
    const clearLoop = (event: KeyboardEvent): void => this.clearLoop(event);
    document.addEventListener('keydown', clearLoop);
    const observer = new ResizeObserver(() => {
      if (this.width !== this.axis.width) this.layout();
    });
    observer.observe(this.area);
    this.stops.push(
      () => document.removeEventListener('keydown', clearLoop),
      () => observer.disconnect(),
      watchPixelRatio(() => this.layout()),
    );
  }

  /** Escape clears the loop where no dialog, menu or panel has the focus. */
  private clearLoop(event: KeyboardEvent): void {
    const { activeElement } = document;
    const free = activeElement === document.body || this.root.contains(activeElement);
    const hidden = this.root.offsetParent === null;
    if (event.key !== 'Escape' || event.defaultPrevented || !free || hidden) return;
    if (this.props.loop !== null) this.events.onLoop(null);
  }
}
