/** Places of items and the room in; where they stand on the screen, and where figures have room, out. */
import type { Point } from './hull';
import { PointGrid } from './point-grid';

export interface Box {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** Screen = offset + scale × place; y of the map grows upward, y of the screen downward. */
export interface MapTransform {
  readonly scale: number;
  readonly x: number;
  readonly y: number;
}

export const onScreen = ({ scale, x, y }: MapTransform, place: Point): Point => [
  x + scale * place[0],
  y - scale * place[1],
];

/** Everything within the room, in the middle, at one scale for both axes. */
export function fitMap(places: Float64Array, room: Box): MapTransform {
  let [minX, maxX, minY, maxY] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let k = 0; k + 1 < places.length; k += 2) {
    minX = Math.min(minX, places[k]);
    maxX = Math.max(maxX, places[k]);
    minY = Math.min(minY, places[k + 1]);
    maxY = Math.max(maxY, places[k + 1]);
  }
  const [width, height] = [room.right - room.left, room.bottom - room.top];
  const middle: Point = [(room.left + room.right) / 2, (room.top + room.bottom) / 2];
  const wanted = Math.min(width / (maxX - minX), height / (maxY - minY));
  const scale = Number.isFinite(wanted) && wanted > 0 ? wanted : 1;
  if (!Number.isFinite(minX)) return { scale, x: middle[0], y: middle[1] };
  return {
    scale,
    x: middle[0] - (scale * (minX + maxX)) / 2,
    y: middle[1] + (scale * (minY + maxY)) / 2,
  };
}

/** Where a map is to fit, and what it may grow into before it is fitted again. */
export interface MapRoom {
  readonly usual: Box;
  readonly outer: Box;
}

/** A fitted map is larger than this by no more. */
const mostSpare = 1.3;

/** The fit that there is as long as everything has room and nothing is lost in the middle of it. */
export function keptFit(fit: MapTransform, places: Float64Array, room: MapRoom): MapTransform {
  const fitted = fitMap(places, room.usual);
  const { left, top, right, bottom } = room.outer;
  const isWithin = (value: number, k: number): boolean => {
    const on = k & 1 ? fit.y - fit.scale * value : fit.x + fit.scale * value;
    return k & 1 ? on >= top && on <= bottom : on >= left && on <= right;
  };
  const keeps = fitted.scale <= mostSpare * fit.scale && places.every(isWithin);
  return keeps ? fit : fitted;
}

export function betweenFits(from: MapTransform, to: MapTransform, part: number): MapTransform {
  const at = (a: number, b: number): number => a + (b - a) * part;
  return { scale: at(from.scale, to.scale), x: at(from.x, to.x), y: at(from.y, to.y) };
}

/** The same with the point under (x, y) held and everything `factor` times as large. */
export function zoomed(
  transform: MapTransform,
  factor: number,
  x: number,
  y: number,
): MapTransform {
  return {
    scale: transform.scale * factor,
    x: x + (transform.x - x) * factor,
    y: y + (transform.y - y) * factor,
  };
}

/** Of places on the way from old to new; `part` 0 to 1. */
export function between(from: Float64Array, to: Float64Array, part: number): Float64Array {
  return to.map((value, k) => from[k] + (value - from[k]) * part);
}

/** The member nearest to the middle of its cluster, as its figure. */
export function middleMember(members: readonly number[], places: Float64Array): number {
  const mean = (axis: 0 | 1): number =>
    members.reduce((sum, item) => sum + places[2 * item + axis], 0) / members.length;
  const [x, y] = [mean(0), mean(1)];
  const distance = (item: number): number =>
    Math.hypot(places[2 * item] - x, places[2 * item + 1] - y);
  return members.reduce((best, item) => (distance(item) < distance(best) ? item : best));
}

const overlaps = (a: Box, b: Box): boolean =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

const within = (box: Box, room: Box): boolean =>
  box.left >= room.left &&
  box.right <= room.right &&
  box.top >= room.top &&
  box.bottom <= room.bottom;

export interface FigureRoom {
  readonly room: Box;
  readonly width: number;
  readonly height: number;
  /** Discs, and half their width. */
  readonly points: readonly Point[];
  readonly radius: number;
  readonly taken: readonly Box[];
}

const angles = 24;
/** From the edge of the hull to the figure: farther away it would not be seen to belong to it. */
const marginsPx = [14, 20, 28];
/** In between the discs, where there is no room around them. */
const reachesPx = [32, 42];

const around = ([x, y]: Point, width: number, height: number): Box => ({
  left: x - width / 2,
  right: x + width / 2,
  top: y - height / 2,
  bottom: y + height / 2,
});

export interface Anchor {
  readonly at: Point;
  /** Corners of the discs that the figure stands for. */
  readonly hull: readonly Point[];
}

/** How far the hull reaches from its anchor in a direction. */
const reachOf = ({ at, hull }: Anchor, [wayX, wayY]: Point): number =>
  hull.reduce((most, [x, y]) => Math.max(most, (x - at[0]) * wayX + (y - at[1]) * wayY), 0);

/** Places around a hull, the nearest to its anchor first, and of equals those that lead out of the middle. */
function candidates(anchor: Anchor, { room, width, height }: FigureRoom): Point[] {
  const [x, y] = anchor.at;
  const outward = Math.atan2(y - (room.top + room.bottom) / 2, x - (room.left + room.right) / 2);
  const outside: { reach: number; at: Point }[] = [];
  const among: Point[] = [];
  for (let k = 0; k < angles; k += 1) {
    const turn = (k % 2 ? -1 : 1) * Math.ceil(k / 2);
    const angle = outward + (turn * 2 * Math.PI) / angles;
    const way: Point = [Math.cos(angle), Math.sin(angle)];
    const half = Math.abs(way[0]) * (width / 2) + Math.abs(way[1]) * (height / 2);
    const place = (reach: number): Point => [x + reach * way[0], y + reach * way[1]];
    for (const margin of marginsPx) {
      const reach = reachOf(anchor, way) + half + margin;
      outside.push({ reach: reach + Math.abs(turn), at: place(reach) });
    }
    among.push(...reachesPx.map(place));
  }
  outside.sort((a, b) => a.reach - b.reach);
  return [...outside.map(({ at }) => at), ...among];
}

/** Middles of a figure beside each anchor that cover neither discs nor each other; null: no room. */
export function placeFigures(
  anchors: readonly Anchor[],
  figures: FigureRoom,
): readonly (Point | null)[] {
  const { room, width, height, points, radius, taken } = figures;
  const boxes = [...taken];
  const grid = new PointGrid(points);
  return anchors.map((anchor) => {
    const free = candidates(anchor, figures).find((middle) => {
      const box = around(middle, width, height);
      if (!within(box, room) || boxes.some((other) => overlaps(box, other))) return false;
      return !grid.isNear(box, radius);
    });
    if (free) boxes.push(around(free, width, height));
    return free ?? null;
  });
}

export type Direction = 'left' | 'right' | 'up' | 'down';

const ways: Readonly<Record<Direction, Point>> = {
  left: [-1, 0],
  right: [1, 0],
  up: [0, -1],
  down: [0, 1],
};

/** The nearest point within 45° of a direction; −1: none. What lies straight ahead counts as nearer. */
export function nearestTowards(
  points: readonly Point[],
  from: number,
  direction: Direction,
): number {
  const [wayX, wayY] = ways[direction];
  let best = -1;
  let least = Infinity;
  points.forEach(([x, y], k) => {
    const [dx, dy] = [x - points[from][0], y - points[from][1]];
    const ahead = dx * wayX + dy * wayY;
    const aside = Math.abs(dx * wayY - dy * wayX);
    const cost = ahead + 2 * aside;
    if (k === from || ahead <= 0 || aside > ahead || cost >= least) return;
    [best, least] = [k, cost];
  });
  return best;
}

/** The point nearest to a place on the screen, not farther than `reach`; −1: none. */
export function pointAt(points: readonly Point[], x: number, y: number, reach: number): number {
  let best = -1;
  let least = reach;
  points.forEach((point, k) => {
    const distance = Math.hypot(point[0] - x, point[1] - y);
    if (distance <= least) [best, least] = [k, distance];
  });
  return best;
}
