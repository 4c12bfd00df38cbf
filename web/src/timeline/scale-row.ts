/** Draws the row of time scales: the traces of candidates and keyposes, as ribbons. */
import { isSparse, type Scene } from './scene';
import type { Run } from './sorted';
import { scaleY } from './scale-axis';
import { TraceOutline } from './trace-outline';

/** Candidates that are not keyposes show their traces while so many at most are in view. */
export const MOST_CANDIDATE_TRACES = 300;
/** Points of ribbons in one drawing; where more are in view, every nth is taken. */
const MOST_POINTS = 4000;
const FOLDED_THICKNESS = 0.5;
const KEYPOSE_ALPHA = 0.82;
const OTHER_ALPHA = 0.38;
const GUIDES_HZ = [16, 8, 4, 2, 1, 0.5, 0.25];

const outline = new TraceOutline();

export function drawScaleRow(context: CanvasRenderingContext2D, scene: Scene): void {
  const { rows, data, palette, keyposes, candidates } = scene;
  if (!rows.scales.folded) drawGuides(context, scene);
  const shown = candidates.to - candidates.from;
  if (shown <= MOST_CANDIDATE_TRACES) {
    const others = candidatesOf(candidates, (candidate) => data.keyposeOf[candidate] < 0);
    fillRibbons(context, scene, others, palette.text3, OTHER_ALPHA);
  }
  if (!isSparse(scene)) return fillLines(context, scene);
  const kept = candidatesOf(keyposes, () => true).map((index) => data.result.keyposes[index]);
  fillRibbons(context, scene, kept, palette.kp, KEYPOSE_ALPHA);
}

/** The trace of one keypose in full colour, above the others. */
export function drawCurrentTrace(
  context: CanvasRenderingContext2D,
  scene: Scene,
  keypose: number,
): void {
  const { data, palette } = scene;
  const candidate = data.result.keyposes[keypose];
  fillRibbons(context, scene, [candidate], palette.kp, 1);
}

function candidatesOf(run: Run, keep: (index: number) => boolean): number[] {
  const indices: number[] = [];
  for (let index = run.from; index < run.to; index++) if (keep(index)) indices.push(index);
  return indices;
}

function drawGuides(
  context: CanvasRenderingContext2D,
  { axis, rows, palette, scaleRange }: Scene,
): void {
  context.beginPath();
  for (const hz of GUIDES_HZ) {
    if (hz >= scaleRange.finestHz || hz <= scaleRange.coarsestHz) continue;
    const y = Math.round(scaleY(rows.scales, hz, scaleRange)) + 0.5;
    context.moveTo(0, y);
    context.lineTo(axis.width, y);
  }
  context.setLineDash([1, 3]);
  context.lineWidth = 1;
  context.strokeStyle = palette.line2;
  context.stroke();
  context.setLineDash([]);
}

/** One path for all: where ribbons lie over each other they are no darker. */
function fillRibbons(
  context: CanvasRenderingContext2D,
  { axis, data, rows, scaleHeights }: Scene,
  candidates: readonly number[],
  colour: string,
  alpha: number,
): void {
  const step = decimation(data.result.traceOffsets, candidates);
  outline.thickness = rows.scales.folded ? FOLDED_THICKNESS : 1;
  context.beginPath();
  for (const candidate of candidates) {
    outline.set(data, candidate, axis, scaleHeights, step);
    outline.addTo(context);
  }
  context.globalAlpha = alpha;
  context.fillStyle = colour;
  context.fill();
  context.globalAlpha = 1;
}

function decimation(offsets: Int32Array, candidates: readonly number[]): number {
  let points = 0;
  for (const candidate of candidates) points += offsets[candidate + 1] - offsets[candidate];
  return Math.max(1, Math.ceil(points / MOST_POINTS));
}

/** One upright line a pixel, as long as the longest trace that stands there. */
function fillLines(
  context: CanvasRenderingContext2D,
  { axis, data, keyposes, palette, scaleHeights: heights }: Scene,
): void {
  const deepest = new Float64Array(Math.ceil(axis.width) + 1);
  const { traceOffsets, traceScales, keyposes: candidateOf } = data.result;
  for (let keypose = keyposes.from; keypose < keyposes.to; keypose++) {
    const end = traceOffsets[candidateOf[keypose] + 1];
    const x = Math.floor(axis.x(data.frames[keypose]));
    if (end === traceOffsets[candidateOf[keypose]] || x < 0 || x >= deepest.length) continue;
    deepest[x] = Math.max(deepest[x], heights[traceScales[end - 1]]);
  }
  const top = heights[0] ?? 0;
  context.globalAlpha = KEYPOSE_ALPHA;
  context.fillStyle = palette.kp;
  for (let x = 0; x < deepest.length; x++)
    if (deepest[x] > 0) context.fillRect(x, top, 1, Math.max(1, deepest[x] - top));
  context.globalAlpha = 1;
}
