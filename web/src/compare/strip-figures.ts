/** What the strips of two selected clips show: the frames of a clip, and one scale for all figures. */
import { keyposeFrames } from '../app/clips';
import type { ClipResult, PerformerResult } from '../engine/types';
import type { FlatFigure } from '../figure/flat-figure';

export const mostFigures = 4;
export const figureBoxWidth = 42;
export const figureBoxHeight = 56;
/** Figures may reach over their box: neighbours seldom reach out at the same height. */
const overlap = 1.3;
const padding = 2;

function mostIntense({ keyposes }: PerformerResult): readonly number[] {
  if (!keyposes) return [];
  const kept = new Set(keyposes.keyposes);
  return [...keyposes.byIntensity].filter((candidate) => kept.has(candidate)).slice(0, mostFigures);
}

/** The most intense keyposes in time order; frames at even distances where there is no keypose. */
export function stripFrames(
  { frames }: Pick<ClipResult, 'frames'>,
  performer: PerformerResult,
): Int32Array {
  const chosen = mostIntense(performer);
  if (chosen.length > 0 && performer.keyposes) {
    const { candidates } = performer.keyposes;
    return Int32Array.from(chosen, (candidate) => candidates[candidate] ?? 0).sort();
  }
  if (keyposeFrames(performer).length > 0 || frames === 0) return new Int32Array();
  const first = Math.min(performer.leadingRestFrames, frames - 1);
  const step = (frames - 1 - first) / mostFigures;
  const places = Array.from({ length: mostFigures }, (_, i) =>
    Math.round(first + (i + 0.5) * step),
  );
  return Int32Array.from(new Set(places));
}

/** Pixels of one body height at which every figure fits. */
export function stripScale(figures: readonly FlatFigure[]): number {
  const fits = figures.map(({ minX, maxX, minY, maxY }) =>
    Math.min(
      (overlap * figureBoxWidth) / Math.max(maxX - minX, 1e-6),
      (figureBoxHeight - 2 * padding) / Math.max(maxY - Math.min(0, minY), 1e-6),
    ),
  );
  return Math.min(figureBoxHeight, ...fits);
}

/** The ground that all share, from the upper edge. */
export function stripGround(figures: readonly FlatFigure[], scale: number): number {
  const lowest = Math.min(0, ...figures.map(({ minY }) => minY));
  return figureBoxHeight - padding + scale * lowest;
}
