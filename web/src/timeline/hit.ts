/** A place in the rows in; the moment of the trace or dot that lies under it out, if one does: pure. */
import { intensityRadius, intensityY } from './intensity-dots';
import { rowAt } from './rows';
import { MOST_CANDIDATE_TRACES } from './scale-row';
import type { Scene } from './scene';
import { TraceOutline } from './trace-outline';

/** How far beside a trace or a dot the pointer may be, in pixels. */
const REACH = 5;
/** With more dots or traces in view than this, none can be meant. */
const CROWD = 1500;

const outline = new TraceOutline();

/** The frame of the candidate whose trace or dot is meant; null where there is none. */
export function candidateAt(scene: Scene, x: number, y: number): number | null {
  const row = rowAt(scene.rows, y);
  const { from, to } = scene.candidates;
  if (to - from > CROWD) return null;
  const distance = row === 'scales' ? traceDistance : row === 'intensity' ? dotDistance : null;
  if (distance === null) return null;
  let [nearest, candidate] = [REACH, -1];
  for (let index = from; index < to; index++) {
    const away = distance(scene, index, x, y);
    if (away < nearest) [nearest, candidate] = [away, index];
  }
  return candidate < 0 ? null : scene.data.result.candidates[candidate];
}

function dotDistance({ axis, rows, data }: Scene, index: number, x: number, y: number): number {
  const intensity = data.result.intensities[index];
  const radius = intensityRadius(rows.intensity, intensity, data.largestIntensity);
  const dx = x - axis.x(data.result.candidates[index]);
  const dy = y - intensityY(rows.intensity, intensity, data.largestIntensity);
  return Math.hypot(dx, dy) - radius;
}

/** Distance to the nearest point of a trace that is drawn. */
function traceDistance(scene: Scene, index: number, x: number, y: number): number {
  const { axis, data, candidates, scaleHeights } = scene;
  const shown =
    data.keyposeOf[index] >= 0 || candidates.to - candidates.from <= MOST_CANDIDATE_TRACES;
  if (!shown) return Infinity;
  outline.set(data, index, axis, scaleHeights, 1);
  let least = Infinity;
  for (let point = 0; point < outline.length; point++) {
    const away = Math.hypot(x - outline.x[point], y - outline.y[point]) - outline.half[point];
    least = Math.min(least, away);
  }
  return least;
}
