/** Dragging and keys on the overview in; the span that the timeline is to show out: pure. */
import type { Axis, AxisSpan } from './axis';
import { fitted, panned, ZOOM_STEP, zoomed } from './zoom';

/** What a press in the overview takes hold of. */
export type BrushPart = 'window' | 'first' | 'last' | 'outside';

/** How near to an edge of the window a press takes hold of it, in pixels. */
const EDGE_REACH = 6;
/** A window narrower than this has no edges to take hold of. */
export const NARROWEST_WITH_EDGES = 24;
/** What the arrow keys move and resize, in parts of the span. */
const KEY_STEP = 0.1;

/** The window in pixels, wide enough to be seen and grasped. */
export function brushWindow(span: AxisSpan, axis: Axis, narrowest: number): AxisSpan {
  const [first, last] = [axis.x(span.first), axis.x(span.last)];
  const missing = Math.max(0, narrowest - (last - first)) / 2;
  return { first: first - missing, last: last + missing };
}

export function brushPart(window: AxisSpan, x: number, isWhole: boolean): BrushPart {
  const wide = window.last - window.first >= NARROWEST_WITH_EDGES;
  if (wide && Math.abs(x - window.first) <= EDGE_REACH) return 'first';
  if (wide && Math.abs(x - window.last) <= EDGE_REACH) return 'last';
  return x >= window.first && x <= window.last && !isWhole ? 'window' : 'outside';
}

/** The span after a drag from one pixel of the overview to another. */
export function brushed(
  part: BrushPart,
  span: AxisSpan,
  axis: Axis,
  fromX: number,
  toX: number,
): AxisSpan | null {
  const moved = (toX - fromX) / axis.scale;
  switch (part) {
    case 'window':
      return panned(span, axis.lastFrame, moved);
    case 'first':
      return between(span.first + moved, span.last, axis.lastFrame);
    case 'last':
      return between(span.first, span.last + moved, axis.lastFrame);
    case 'outside':
      return between(axis.placeAt(fromX), axis.placeAt(toX), axis.lastFrame);
  }
}

/** A span of its ends, in either order, each within the clip. */
function between(one: number, other: number, lastFrame: number): AxisSpan | null {
  const within = (frame: number): number => Math.min(lastFrame, Math.max(0, frame));
  const [first, last] = [within(Math.min(one, other)), within(Math.max(one, other))];
  return fitted({ first, last }, lastFrame);
}

/** The span after a key; undefined for keys that mean nothing here. */
export function spanAfterKey(
  key: string,
  shift: boolean,
  span: AxisSpan,
  lastFrame: number,
): AxisSpan | null | undefined {
  const length = span.last - span.first;
  const middle = (span.first + span.last) / 2;
  switch (key) {
    case 'ArrowLeft':
    case 'ArrowRight': {
      const step = (key === 'ArrowLeft' ? -1 : 1) * KEY_STEP * length;
      if (!shift) return panned(span, lastFrame, step);
      return between(span.first, Math.max(span.first, span.last + step), lastFrame);
    }
    case 'Home':
      return panned(span, lastFrame, -lastFrame);
    case 'End':
      return panned(span, lastFrame, lastFrame);
    case '+':
    case '=':
      return zoomed(span, lastFrame, ZOOM_STEP, middle);
    case '-':
      return zoomed(span, lastFrame, 1 / ZOOM_STEP, middle);
    case '0':
    case 'Escape':
      return null;
    default:
      return undefined;
  }
}
