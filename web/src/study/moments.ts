/** Keyposes and the current one in; the moments around it out: which ghosts stand there, which frames a trail goes through. */

/** A keypose at a frame; numbers from 1, as people count them. */
export interface NumberedFrame {
  readonly number: number;
  readonly frame: number;
}

/** Points of a trail at most, and as many a second as a curve needs to be smooth. */
const mostPoints = 600;
const pointsPerSecond = 60;
/** How far a trail reaches where there is no keypose on that side. */
const reachS = 2;

/** The keyposes before and after the current one. */
export function ghostMoments(keyposes: Int32Array, current: number | null): NumberedFrame[] {
  if (current === null) return [];
  return [current - 1, current + 1]
    .filter((index) => index >= 0 && index < keyposes.length)
    .map((index) => ({ number: index + 1, frame: keyposes[index] }));
}

export interface ClipTime {
  /** The first frame that is no leading rest. */
  readonly firstFrame: number;
  readonly lastFrame: number;
  readonly frameTimeS: number;
}

/** Frames from the previous keypose to the next, ascending, the ends and the current one among them. */
export function trailFrames(
  keyposes: Int32Array,
  current: number | null,
  { firstFrame, lastFrame, frameTimeS }: ClipTime,
): Int32Array {
  if (current === null) return new Int32Array();
  const at = keyposes[current];
  const reach = Math.round(reachS / frameTimeS);
  const from = current > 0 ? keyposes[current - 1] : Math.max(firstFrame, at - reach);
  const to =
    current + 1 < keyposes.length ? keyposes[current + 1] : Math.min(lastFrame, at + reach);
  const smooth = Math.floor(1 / (pointsPerSecond * frameTimeS) + 0.01);
  const step = Math.max(1, smooth, Math.ceil((to - from) / (mostPoints - 3)));
  const frames = new Set([at, to]);
  for (let frame = from; frame < to; frame += step) frames.add(frame);
  return Int32Array.from(frames).sort();
}
