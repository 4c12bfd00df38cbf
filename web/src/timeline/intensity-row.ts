/** Draws the row of intensity: a dot for every candidate, filled for keyposes, and the cut between them. */
import { paintDots } from './dots';
import { DotGrid, intensityRadius, intensityY, ZERO_RADIUS } from './intensity-dots';
import { isSparse, type Scene } from './scene';
import type { Run } from './sorted';

/** From so many candidates in view on, they are specks. */
const CROWD = 600;
/** Side of the smallest square that stands for dots in a crowd, in pixels. */
const SPECK = 2;

export function drawIntensityRow(context: CanvasRenderingContext2D, scene: Scene): void {
  drawCut(context, scene);
  drawZeros(context, scene);
  drawCandidates(context, scene);
  drawKeyposes(context, scene);
}

/** The current keypose's dot with a ring around it. */
export function drawCurrentDot(
  context: CanvasRenderingContext2D,
  scene: Scene,
  keypose: number,
): void {
  const { axis, rows, data, palette } = scene;
  const intensity = data.result.intensities[data.result.keyposes[keypose]];
  const x = axis.x(data.frames[keypose]);
  const y = intensityY(rows.intensity, intensity, data.largestIntensity);
  const radius = intensityRadius(rows.intensity, intensity, data.largestIntensity);
  context.beginPath();
  context.arc(x, y, radius + 1.25, 0, 2 * Math.PI);
  context.fillStyle = palette.panel;
  context.fill();
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = palette.kp;
  context.fill();
  context.beginPath();
  context.arc(x, y, radius + 2.5, 0, 2 * Math.PI);
  context.strokeStyle = palette.kp;
  context.lineWidth = 1.25;
  context.stroke();
}

function drawCut(context: CanvasRenderingContext2D, { axis, rows, data, palette }: Scene): void {
  const { cut } = data.result;
  if (cut === null) return;
  const row = rows.intensity;
  const y = intensityY(row, cut, data.largestIntensity);
  context.globalAlpha = 0.03;
  context.fillStyle = palette.ink;
  context.fillRect(0, y, axis.width, row.top + row.height - y);
  context.globalAlpha = 1;
  context.beginPath();
  context.moveTo(0, Math.round(y) + 0.5);
  context.lineTo(axis.width, Math.round(y) + 0.5);
  context.setLineDash([4, 3]);
  context.lineWidth = 1;
  context.strokeStyle = palette.kp;
  context.stroke();
  context.setLineDash([]);
}

/** Candidates without intensity: specks on the ground line, at most one a pixel. */
function drawZeros(
  context: CanvasRenderingContext2D,
  { axis, rows, data, palette, candidates }: Scene,
): void {
  const { intensities, candidates: frames } = data.result;
  const y = intensityY(rows.intensity, 0, data.largestIntensity);
  let last = -Infinity;
  context.globalAlpha = 0.7;
  context.fillStyle = palette.text3;
  for (let index = candidates.from; index < candidates.to; index++) {
    if (intensities[index] > 0) continue;
    const x = axis.x(frames[index]);
    if (x - last < 1) continue;
    last = x;
    context.fillRect(x - ZERO_RADIUS, y - ZERO_RADIUS, 2 * ZERO_RADIUS, 2 * ZERO_RADIUS);
  }
  context.globalAlpha = 1;
}

/** Candidates of some intensity that are no keyposes: rings. */
function drawCandidates(context: CanvasRenderingContext2D, scene: Scene): void {
  const { palette, data, candidates } = scene;
  const candidateOf = (index: number): number =>
    data.keyposeOf[index] < 0 && data.result.intensities[index] > 0 ? index : -1;
  if (candidates.to - candidates.from > CROWD)
    return fillSpecks(context, scene, candidates, candidateOf, palette.text3);
  addDots(context, scene, candidates, candidateOf);
  paintDots(context, palette.panel, palette.text3, 1);
}

function drawKeyposes(context: CanvasRenderingContext2D, scene: Scene): void {
  const { palette, data, keyposes } = scene;
  const candidateOf = (index: number): number => data.result.keyposes[index];
  if (!isSparse(scene)) return fillSpecks(context, scene, keyposes, candidateOf, palette.kp);
  addDots(context, scene, keyposes, candidateOf);
  paintDots(context, palette.kp, palette.panel, 1);
}

/** The candidate of an index of a run; -1 where it is left out. */
type CandidateOf = (index: number) => number;

/** A path of the dots of candidates. */
function addDots(
  context: CanvasRenderingContext2D,
  { axis, rows, data }: Scene,
  run: Run,
  candidateOf: CandidateOf,
): void {
  const { intensities, candidates: frames } = data.result;
  context.beginPath();
  for (let index = run.from; index < run.to; index++) {
    const candidate = candidateOf(index);
    if (candidate < 0) continue;
    const x = axis.x(frames[candidate]);
    const y = intensityY(rows.intensity, intensities[candidate], data.largestIntensity);
    const radius = intensityRadius(rows.intensity, intensities[candidate], data.largestIntensity);
    context.moveTo(x + radius, y);
    context.arc(x, y, radius, 0, 2 * Math.PI);
  }
}

/** In a crowd: one square for all dots that would lie over each other, the larger the more intense. */
function fillSpecks(
  context: CanvasRenderingContext2D,
  { axis, rows, data }: Scene,
  run: Run,
  candidateOf: CandidateOf,
  colour: string,
): void {
  const { intensities, candidates: frames } = data.result;
  const row = rows.intensity;
  const grid = new DotGrid(axis.width, row.height, SPECK);
  context.fillStyle = colour;
  for (let index = run.from; index < run.to; index++) {
    const candidate = candidateOf(index);
    if (candidate < 0) continue;
    const x = Math.floor(axis.x(frames[candidate]) / SPECK);
    const y = Math.floor(intensityY(row, intensities[candidate], data.largestIntensity) / SPECK);
    if (!grid.take(x, y - Math.floor(row.top / SPECK))) continue;
    const radius = intensityRadius(row, intensities[candidate], data.largestIntensity);
    const side = Math.max(SPECK, radius);
    context.fillRect(x * SPECK, y * SPECK - (side - SPECK) / 2, side, side);
  }
}
