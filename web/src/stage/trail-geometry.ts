/** In: the path of a joint in the scene. Out: a thin tube along it, in numbers for the graphics; no three.js. */

/** Corners of the tube's cross-section. */
export const TUBE_CORNERS = 6;
/** A point nearer than this to the one before adds nothing, in body heights. */
const LEAST_STEP = 0.002;

/** A joint's path: points × (x, y, z), the time of each from 0 to 1, the side whose colour it has. */
export interface TrailPath {
  readonly points: Float32Array;
  readonly times: Float32Array;
  /** As in the cone texture: 0 left, 1 right, 2 trunk. */
  readonly side: number;
}

export interface TubeArrays {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly times: Float32Array;
  readonly sides: Float32Array;
  readonly index: Uint32Array;
}

/** One mesh for all paths: all tubes are drawn in one call. */
export function tubes(paths: readonly TrailPath[], radius: number): TubeArrays {
  const drawn = paths
    .map((path) => ({ path, kept: distinctPoints(path) }))
    .filter(({ kept }) => kept.length > 1);
  const rings = drawn.reduce((sum, { kept }) => sum + kept.length, 0);
  const bands = rings - drawn.length;
  const out: TubeArrays = {
    positions: new Float32Array(rings * TUBE_CORNERS * 3),
    normals: new Float32Array(rings * TUBE_CORNERS * 3),
    times: new Float32Array(rings * TUBE_CORNERS),
    sides: new Float32Array(rings * TUBE_CORNERS),
    index: new Uint32Array(bands * TUBE_CORNERS * 6),
  };
  let ring = 0;
  let band = 0;
  for (const { path, kept } of drawn) {
    writeTube(path, kept, radius, ring, out);
    writeIndex(kept.length, ring, band, out.index);
    ring += kept.length;
    band += kept.length - 1;
  }
  return out;
}

/** Indices of the points that are there and stand apart from each other. */
function distinctPoints({ points, times }: TrailPath): number[] {
  const kept: number[] = [];
  for (let i = 0; i < times.length; i++) {
    if (!isFinitePoint(points, i)) continue;
    const before = kept[kept.length - 1] as number | undefined;
    if (before === undefined || distance(points, before, i) >= LEAST_STEP) kept.push(i);
  }
  return kept;
}

type Vector = [number, number, number];

/** Rings around the points; the first corner turns as little as it can from ring to ring. */
function writeTube(
  { points, times, side }: TrailPath,
  kept: readonly number[],
  radius: number,
  firstRing: number,
  out: TubeArrays,
): void {
  let across: Vector = [0, 0, 0];
  kept.forEach((point, i) => {
    const along = direction(
      points,
      kept[Math.max(0, i - 1)],
      kept[Math.min(kept.length - 1, i + 1)],
    );
    across = squareTo(across, along);
    const other = cross(along, across);
    for (let corner = 0; corner < TUBE_CORNERS; corner++) {
      const vertex = (firstRing + i) * TUBE_CORNERS + corner;
      const angle = (2 * Math.PI * corner) / TUBE_CORNERS;
      for (let axis = 0; axis < 3; axis++) {
        const normal = Math.cos(angle) * across[axis] + Math.sin(angle) * other[axis];
        out.normals[vertex * 3 + axis] = normal;
        out.positions[vertex * 3 + axis] = points[point * 3 + axis] + radius * normal;
      }
      out.times[vertex] = times[point];
      out.sides[vertex] = side;
    }
  });
}

function writeIndex(rings: number, firstRing: number, firstBand: number, index: Uint32Array): void {
  let at = firstBand * TUBE_CORNERS * 6;
  for (let ring = firstRing; ring < firstRing + rings - 1; ring++) {
    for (let corner = 0; corner < TUBE_CORNERS; corner++) {
      const a = ring * TUBE_CORNERS + corner;
      const b = ring * TUBE_CORNERS + ((corner + 1) % TUBE_CORNERS);
      index.set([a, b, a + TUBE_CORNERS, b, b + TUBE_CORNERS, a + TUBE_CORNERS], at);
      at += 6;
    }
  }
}

function isFinitePoint(points: Float32Array, i: number): boolean {
  return Number.isFinite(points[i * 3] + points[i * 3 + 1] + points[i * 3 + 2]);
}

function distance(points: Float32Array, a: number, b: number): number {
  const [x, y, z] = [0, 1, 2].map((axis) => points[b * 3 + axis] - points[a * 3 + axis]);
  return Math.hypot(x, y, z);
}

function direction(points: Float32Array, a: number, b: number): Vector {
  const from = (axis: number): number => points[b * 3 + axis] - points[a * 3 + axis];
  return normalised([from(0), from(1), from(2)], [0, 1, 0]);
}

/** The vector turned square to `along`; any that is, where they lie along each other. */
function squareTo(vector: Vector, along: Vector): Vector {
  const part = dot(vector, along);
  const rest: Vector = [0, 0, 0];
  for (let axis = 0; axis < 3; axis++) rest[axis] = vector[axis] - part * along[axis];
  const any: Vector = Math.abs(along[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0];
  return normalised(rest, normalised(cross(along, any), any));
}

function normalised(vector: Vector, otherwise: Vector): Vector {
  const length = Math.hypot(...vector);
  return length > 1e-9 ? [vector[0] / length, vector[1] / length, vector[2] / length] : otherwise;
}

function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
