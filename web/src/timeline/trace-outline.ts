/** The trace of a candidate over the time scales as a ribbon in pixels: pure geometry. */
import type { Axis } from './axis';
import type { TimelineData } from './timeline-data';

const THINNEST = 0.45;
const THICKEST = 3.6;

/** Half the width of a ribbon where the trace's strength is u. */
export function halfWidth(strength: number, largest: number): number {
  return THINNEST + (largest > 0 ? (THICKEST - THINNEST) * (strength / largest) : 0);
}

/** Middle and half-width of one trace in pixels, one place for each scale; written anew for each trace. */
export class TraceOutline {
  length = 0;
  x = new Float64Array(128);
  y = new Float64Array(128);
  half = new Float64Array(128);
  /** 1, or less where the row is folded. */
  thickness = 1;

  /** Takes every `step`th point of a candidate's trace, and its ends. */
  set(
    data: TimelineData,
    candidate: number,
    axis: Axis,
    heights: Float64Array,
    step: number,
  ): void {
    const { traceOffsets, traceScales, tracePlaces, traceIntensities } = data.result;
    const end = traceOffsets[candidate + 1];
    this.length = 0;
    this.makeRoom(end - traceOffsets[candidate]);
    for (let point = traceOffsets[candidate]; point < end;) {
      this.x[this.length] = axis.x(tracePlaces[point]);
      this.y[this.length] = heights[traceScales[point]];
      this.half[this.length] =
        this.thickness * halfWidth(traceIntensities[point], data.largestStrength);
      this.length++;
      point = point < end - 1 ? Math.min(end - 1, point + step) : end;
    }
  }

  /** Adds the ribbon to a path: down its one side and up the other, square to its course. */
  addTo(path: Pick<CanvasPath, 'moveTo' | 'lineTo' | 'closePath'>): void {
    const { length, x, y } = this;
    if (length === 1) return this.addPoint(path);
    for (let index = 0; index < length; index++) {
      const [across, down] = this.offset(index);
      if (index === 0) path.moveTo(x[index] + across, y[index] + down);
      else path.lineTo(x[index] + across, y[index] + down);
    }
    for (let index = length - 1; index >= 0; index--) {
      const [across, down] = this.offset(index);
      path.lineTo(x[index] - across, y[index] - down);
    }
    if (length > 0) path.closePath();
  }

  private offset(index: number): readonly [number, number] {
    const before = Math.max(0, index - 1);
    const after = Math.min(this.length - 1, index + 1);
    const dx = this.x[after] - this.x[before];
    const dy = this.y[after] - this.y[before];
    const scale = this.half[index] / (Math.hypot(dx, dy) || 1);
    return [-dy * scale, dx * scale];
  }

  /** A trace of one scale alone: a short upright mark. */
  private addPoint(path: Pick<CanvasPath, 'moveTo' | 'lineTo' | 'closePath'>): void {
    const [x, y, half] = [this.x[0], this.y[0], this.half[0]];
    path.moveTo(x - half, y - 1);
    path.lineTo(x + half, y - 1);
    path.lineTo(x + half, y + 1);
    path.lineTo(x - half, y + 1);
    path.closePath();
  }

  private makeRoom(points: number): void {
    if (points <= this.x.length) return;
    this.x = new Float64Array(2 * points);
    this.y = new Float64Array(2 * points);
    this.half = new Float64Array(2 * points);
  }
}
