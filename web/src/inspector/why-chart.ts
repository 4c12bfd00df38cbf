/** u over the time scales: the subject in colour, the other keyposes grey behind it, all on one scale. */
import { html, nothing, svg, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import type { KeyposeResult } from '../engine/types';
import {
  areaPath,
  baseline,
  chartHeight,
  curveAt,
  curvePath,
  whyCurves,
  type Curve,
  type ScaleAxis,
  type WhyCurves,
} from './why-layout';

export interface WhyChart {
  readonly words: Words;
  readonly keyposes: KeyposeResult;
  readonly candidate: number;
  /** Another keypose that is hovered over, here or elsewhere. */
  readonly hovered: number | null;
  /** The coarsest scale that was asked for. */
  readonly coarsestHz: number;
  readonly width: number;
  readonly onHover: (candidate: number | null) => void;
  readonly onGo: (candidate: number) => void;
}

let latest: {
  keyposes: KeyposeResult;
  coarsestHz: number;
  width: number;
  curves: WhyCurves;
} | null = null;

/** Laid out anew only for another result, range or width. */
function curvesOf({ keyposes, coarsestHz, width }: WhyChart): WhyCurves {
  const same =
    latest?.keyposes === keyposes && latest.coarsestHz === coarsestHz && latest.width === width;
  if (!latest || !same)
    latest = { keyposes, coarsestHz, width, curves: whyCurves(keyposes, coarsestHz, width) };
  return latest.curves;
}

const axisEdgePx = 3;

function axisMarks({ t, format }: Words, { ticks }: ScaleAxis, width: number): TemplateResult {
  const label = (hz: number, last: boolean): string =>
    last ? t('unit.hertz', format.short(hz, 2)) : format.short(hz, 2);
  const anchor = (x: number): string =>
    x < axisEdgePx ? 'start' : x > width - axisEdgePx ? 'end' : 'middle';
  return svg`${ticks.map(
    ({ x, hz }, index) => svg`
    <line class="why-tick" x1=${x} x2=${x} y1="4" y2=${baseline} />
    <text class="why-label" x=${x} y=${chartHeight - 3} text-anchor=${anchor(x)}>${label(hz, index === ticks.length - 1)}</text>`,
  )}
    <line class="why-foot" x1="0" x2=${width} y1=${baseline} y2=${baseline} />`;
}

/** Index into the trace of its largest u; the scale is the core's. */
function strongestPoint(
  { keyposes, candidate }: WhyChart,
  { points }: Curve,
): TemplateResult | typeof nothing {
  const scale = keyposes.strongestScales[candidate] ?? -1;
  const first = keyposes.traceOffsets[candidate] ?? 0;
  const at = keyposes.traceScales.subarray(first, first + points.length / 2).indexOf(scale);
  if (scale < 0 || at < 0) return nothing;
  return svg`<circle class="why-dot" cx=${points[2 * at] ?? 0} cy=${points[2 * at + 1] ?? 0} r="3" />`;
}

/** The chart in words. */
function spokenText({ words: { t, format }, keyposes, candidate }: WhyChart): string {
  const { scalesHz, traceOffsets, traceScales, strongestScales, traceIntensities } = keyposes;
  const first = traceOffsets[candidate] ?? 0;
  const end = traceOffsets[candidate + 1] ?? first;
  const scale = strongestScales[candidate] ?? -1;
  if (end === first || scale < 0) return t('why.chart.none');
  const hz = (index: number): string => format.short(scalesHz[index] ?? 0, 2);
  const at = first + traceScales.subarray(first, end).indexOf(scale);
  const u = format.short(traceIntensities[at] ?? 0, 2);
  return t('why.chart', hz(traceScales[first] ?? 0), hz(traceScales[end - 1] ?? 0), u, hz(scale));
}

export function whyChart(chart: WhyChart): TemplateResult {
  const { words, candidate, hovered, width, onHover, onGo } = chart;
  const { axis, curves, curveOf } = curvesOf(chart);
  const own = curveOf(candidate);
  const others = curves.filter((curve) => curve.candidate !== candidate);
  const under = (event: MouseEvent): number | null => {
    const box = (event.currentTarget as Element).getBoundingClientRect();
    const scale = width / (box.width || 1);
    return curveAt(others, (event.clientX - box.left) * scale, (event.clientY - box.top) * scale);
  };
  const go = (event: MouseEvent): void => {
    const other = under(event);
    if (other !== null) onGo(other);
  };
  const marked = hovered === null || hovered === candidate ? null : curveOf(hovered);
  return html`<svg
    class="why-chart"
    viewBox="0 0 ${width} ${chartHeight}"
    role="img"
    aria-label=${spokenText(chart)}
    @pointermove=${(event: PointerEvent) => onHover(under(event))}
    @pointerleave=${() => onHover(null)}
    @click=${go}
  >
    ${axisMarks(words, axis, width)}
    ${others.map((curve) => svg`<path class="why-other" d=${curvePath(curve)} />`)}
    ${marked ? svg`<path class="why-hovered" d=${curvePath(marked)} />` : nothing}
    <path class="why-area" d=${areaPath(own)} />
    <path class="why-curve" d=${curvePath(own)} />
    ${strongestPoint(chart, own)}
  </svg>`;
}
