/** The ruler: ticks on the canvas of the rows, labels with seconds and frames as text. */
import type { Axis } from './axis';
import type { Palette } from './palette';
import { clockTime, type Division, labelWidth, type Tick } from './ruler-layout';
import type { Row } from './rows';
import type { TimelineText } from './timeline-text';

/** Half the playhead's flag and a little air. */
const FLAG_HALF_WIDTH = 26;
const LABEL_LEFT = 4;
const TICK_HEIGHT = { major: 9, middle: 6, minor: 4 } as const;

interface Label {
  readonly node: HTMLElement;
  readonly time: Text;
  readonly frame: HTMLElement;
  x: number;
}

export class Ruler {
  readonly element = document.createElement('div');
  private readonly labels: Label[] = [];
  private shown = 0;
  private width = 0;

  constructor() {
    this.element.className = 'ruler';
    this.element.setAttribute('aria-hidden', 'true');
  }

  update(
    axis: Axis,
    frameTimeS: number,
    ticks: readonly Tick[],
    division: Division,
    text: TimelineText,
  ): void {
    this.width = labelWidth(axis, frameTimeS, division.digits) - LABEL_LEFT;
    this.shown = 0;
    for (const tick of ticks) {
      const inside = tick.x >= 0 && tick.x + this.width < axis.width;
      if (tick.size === 'major' && inside) this.show(tick, division.digits, text);
    }
    this.labels.forEach(({ node }, index) => {
      node.hidden = index >= this.shown;
    });
  }

  /** Hides the labels that a time flag or a tab of the loop at one of these pixels would cover. */
  makeRoom(places: readonly number[]): void {
    for (const { x, node } of this.labels) {
      const covered = places.some(
        (place) => x < place + FLAG_HALF_WIDTH && x + this.width > place - FLAG_HALF_WIDTH,
      );
      node.classList.toggle('covered', covered);
    }
  }

  private show(tick: Tick, digits: number, text: TimelineText): void {
    const label = this.labels[this.shown] ?? this.create();
    this.shown++;
    label.x = tick.x;
    label.node.style.transform = `translateX(${tick.x + LABEL_LEFT}px)`;
    label.time.data = rulerTime(tick.timeS, digits, text);
    label.frame.textContent = text.count(tick.frame);
  }

  private create(): Label {
    const node = document.createElement('span');
    const time = document.createTextNode('');
    const frame = document.createElement('small');
    node.className = 'ruler-label';
    node.append(time, frame);
    this.element.append(node);
    const label = { node, time, frame, x: 0 };
    this.labels.push(label);
    return label;
  }
}

export function drawRulerTicks(
  context: CanvasRenderingContext2D,
  ticks: readonly Tick[],
  row: Row,
  palette: Palette,
): void {
  const bottom = row.top + row.height - 1;
  for (const { x, size } of ticks) {
    context.fillStyle = size === 'major' ? palette.text3 : palette.line2;
    context.fillRect(Math.round(x), bottom - TICK_HEIGHT[size], 1, TICK_HEIGHT[size]);
  }
}

/** "0.5 s" below a minute, "1:30" from there on. */
function rulerTime(timeS: number, digits: number, text: TimelineText): string {
  return timeS < 59.9995 ? text.withUnit(text.seconds(timeS, digits)) : clockTime(timeS, digits);
}
