/**
 * What part of a clip the timeline shows, after zooming, panning or following a frame: pure. In and out
 * go spans in frames of the file, which need not be whole; out comes null where that is the whole clip.
 */
import type { AxisSpan } from './axis';

/** The shortest span that can be zoomed to, in frames. */
export const SHORTEST_SPAN = 20;
/** What one press of the zoom buttons does. */
export const ZOOM_STEP = 2;
/** Air around a frame that is scrolled to, in parts of the span. */
const MARGIN = 0.08;

/** All frames of a clip. */
export function wholeSpan(lastFrame: number): AxisSpan {
  return { first: 0, last: lastFrame };
}

/** A span as near to the one given as the clip and the shortest span allow. */
export function fitted(span: AxisSpan, lastFrame: number): AxisSpan | null {
  const shortest = Math.min(SHORTEST_SPAN, lastFrame);
  const length = Math.min(lastFrame, Math.max(shortest, span.last - span.first));
  if (!(length < lastFrame)) return null;
  const middle = (span.first + span.last) / 2;
  const first = Math.min(lastFrame - length, Math.max(0, middle - length / 2));
  return { first, last: first + length };
}

/**
 * Zooms in by a factor above 1, out by one below; `about` keeps its place. A place outside the span is
 * brought to its middle.
 */
export function zoomed(
  span: AxisSpan,
  lastFrame: number,
  factor: number,
  about: number,
): AxisSpan | null {
  const before = Math.max(1e-9, span.last - span.first);
  const shortest = Math.min(SHORTEST_SPAN, lastFrame);
  const length = Math.min(lastFrame, Math.max(shortest, before / factor));
  const inside = about >= span.first && about <= span.last;
  const part = inside ? (about - span.first) / before : 0.5;
  const first = about - part * length;
  return fitted({ first, last: first + length }, lastFrame);
}

/** Moves on by frames, back by a negative number, up to the ends of the clip. */
export function panned(span: AxisSpan, lastFrame: number, frames: number): AxisSpan | null {
  return fitted({ first: span.first + frames, last: span.last + frames }, lastFrame);
}

/** The span scrolled just so far that a frame lies in it, with a little air; as it is where it does. */
export function revealed(span: AxisSpan, lastFrame: number, frame: number): AxisSpan | null {
  const air = MARGIN * (span.last - span.first);
  if (frame < span.first) return panned(span, lastFrame, frame - air - span.first);
  if (frame > span.last) return panned(span, lastFrame, frame + air - span.last);
  return fitted(span, lastFrame);
}

/** The next page during playback: once a frame has left the span, it stands near its beginning. */
export function paged(span: AxisSpan, lastFrame: number, frame: number): AxisSpan | null {
  if (frame >= span.first && frame <= span.last) return fitted(span, lastFrame);
  return pageFrom(span, lastFrame, frame);
}

/** The page near whose beginning a frame stands. */
export function pageFrom(span: AxisSpan, lastFrame: number, frame: number): AxisSpan | null {
  const air = MARGIN * (span.last - span.first);
  return panned(span, lastFrame, frame - air - span.first);
}
