/** What stands in the rows as text: their ends at the right, the tab of the cut, and a spoken summary of each. */
import type { FoldableRow } from '../app/store';
import { element } from '../common/element';
import { intensityY } from './intensity-dots';
import { foldableRows, type RowLayout } from './rows';
import type { TimelineData } from './timeline-data';
import type { TimelineText } from './timeline-text';
import { scaleRangeOf, scaleY, type ScaleRange } from './scale-axis';

/** The frequency labelled between the ends of the scales, where it has room. */
const MIDDLE_HZ = 1;
const LABEL_HEIGHT = 14;

export class RowLabels {
  readonly element = element('div', 'row-labels');
  private readonly summaries: Record<FoldableRow, HTMLElement> = {
    speed: element('div', 'row-summary'),
    scales: element('div', 'row-summary'),
    intensity: element('div', 'row-summary'),
  };
  private readonly maximum = element('span', 'row-end');
  private readonly finest = element('span', 'row-end');
  private readonly middle = element('span', 'row-end');
  private readonly coarsest = element('span', 'row-end');
  private readonly cut = element('span', 'cut-tab');

  constructor() {
    for (const summary of Object.values(this.summaries)) summary.setAttribute('role', 'img');
    this.element.append(
      ...Object.values(this.summaries),
      this.maximum,
      this.finest,
      this.middle,
      this.coarsest,
      this.cut,
    );
  }

  update(
    rows: RowLayout,
    data: TimelineData | null,
    wanted: ScaleRange | null,
    text: TimelineText,
  ): void {
    for (const row of foldableRows) {
      const { style } = this.summaries[row];
      style.top = `${rows[row].top}px`;
      style.height = `${rows[row].height}px`;
      this.summaries[row].hidden = data === null || rows[row].height === 0;
    }
    for (const node of [this.maximum, this.finest, this.middle, this.coarsest, this.cut])
      node.hidden = true;
    if (data === null) return;
    const range = scaleRangeOf(data.result.scalesHz, wanted);
    this.speak(data, range, text);
    this.labelSpeed(rows, data, text);
    this.labelScales(rows, range, text);
    this.labelCut(rows, data, text);
  }

  private speak(
    { result, frames }: TimelineData,
    { finestHz, coarsestHz }: ScaleRange,
    text: TimelineText,
  ): void {
    const { candidates } = result;
    const { speed, scales, intensity } = this.summaries;
    speed.setAttribute('aria-label', text.speedSummary(result.maximumSpeed));
    scales.setAttribute(
      'aria-label',
      text.scalesSummary(finestHz, coarsestHz, frames.length, candidates.length),
    );
    intensity.setAttribute(
      'aria-label',
      text.intensitySummary(candidates.length, frames.length, result.cut),
    );
  }

  private labelSpeed(rows: RowLayout, { result }: TimelineData, text: TimelineText): void {
    if (result.speed.length > 0)
      show(this.maximum, text.figure(result.maximumSpeed), rows.speed.top + 2);
  }

  private labelScales(rows: RowLayout, range: ScaleRange, text: TimelineText): void {
    const row = rows.scales;
    if (row.folded) return;
    const [top, bottom] = [row.top + 2, row.top + row.height - LABEL_HEIGHT - 2];
    show(this.finest, text.short(range.finestHz), top);
    show(this.coarsest, text.hertz(range.coarsestHz), bottom);
    const middle = scaleY(row, MIDDLE_HZ, range) - LABEL_HEIGHT / 2;
    const hasRoom = middle >= top + LABEL_HEIGHT && middle <= bottom - LABEL_HEIGHT + 2;
    if (hasRoom) show(this.middle, text.short(MIDDLE_HZ), middle);
  }

  private labelCut(rows: RowLayout, data: TimelineData, text: TimelineText): void {
    const { cut } = data.result;
    if (cut === null || rows.intensity.folded) return;
    show(this.cut, text.automatic, intensityY(rows.intensity, cut, data.largestIntensity));
  }
}

function show(node: HTMLElement, words: string, top: number): void {
  node.hidden = false;
  node.textContent = words;
  node.style.top = `${top}px`;
}
