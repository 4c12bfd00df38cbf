/** Draws the row of intensity: a dot for every candidate, filled for keyposes, and the cut between them. */
import { DotGrid, intensityRadius, intensityY, ZERO_RADIUS } from './intensity-dots';
import type { Scene } from './scene';

/** From so many candidates in view on, dots that would hide each other are left out. */
const CROWD = 600;
const CROWD_CELL = 2;

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
  context.beginPath();
  for (let index = candidates.from; index < candidates.to; index++) {
    if (intensities[index] > 0) continue;
    const x = axis.x(frames[index]);
    if (x - last < 1) continue;
    last = x;
    context.moveTo(x + ZERO_RADIUS, y);
    context.arc(x, y, ZERO_RADIUS, 0, 2 * Math.PI);
  }
  context.globalAlpha = 0.7;
  context.fillStyle = palette.text3;
  context.fill();
  context.globalAlpha = 1;
}

/** Candidates of some intensity that are no keyposes: rings. */
function drawCandidates(context: CanvasRenderingContext2D, scene: Scene): void {
  const { palette, data, candidates } = scene;
  addDots(context, scene, candidates.from, candidates.to, (candidate) =>
    data.keyposeOf[candidate] < 0 && data.result.intensities[candidate] > 0 ? candidate : -1,
  );
  context.fillStyle = palette.panel;
  context.strokeStyle = palette.text3;
  context.lineWidth = 1;
  context.fill();
  context.stroke();
}

function drawKeyposes(context: CanvasRenderingContext2D, scene: Scene): void {
  const { palette, data, keyposes } = scene;
  addDots(context, scene, keyposes.from, keyposes.to, (index) => data.result.keyposes[index]);
  context.fillStyle = palette.kp;
  context.strokeStyle = palette.panel;
  context.lineWidth = 1;
  context.fill();
  context.stroke();
}

/** A path of the dots of candidates; `candidateOf` gives -1 for those that are left out. */
function addDots(
  context: CanvasRenderingContext2D,
  { axis, rows, data }: Scene,
  from: number,
  to: number,
  candidateOf: (index: number) => number,
): void {
  const { intensities, candidates: frames } = data.result;
  const row = rows.intensity;
  const grid = to - from > CROWD ? new DotGrid(axis.width, row.height, CROWD_CELL) : null;
  context.beginPath();
  for (let index = from; index < to; index++) {
    const candidate = candidateOf(index);
    if (candidate < 0) continue;
    const x = axis.x(frames[candidate]);
    const y = intensityY(row, intensities[candidate], data.largestIntensity);
    if (grid !== null && !grid.take(x, y - row.top)) continue;
    const radius = intensityRadius(row, intensities[candidate], data.largestIntensity);
    context.moveTo(x + radius, y);
    context.arc(x, y, radius, 0, 2 * Math.PI);
  }
}
