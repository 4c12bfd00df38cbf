/** In: a preset, the yaws of the clip, the shape of the stage. Out: where the camera stands; no three.js. */

export type ViewPreset = 'front' | 'side' | 'top';

/** A camera on a ball around its target; yaw as in figure/up-frame.ts, lengths in body heights. */
export interface View {
  yawRad: number;
  elevationRad: number;
  distance: number;
  targetX: number;
  targetY: number;
  targetZ: number;
}

/** From where around its target a camera looks, and how far away. */
export type Look = Pick<View, 'yawRad' | 'elevationRad' | 'distance'>;

/** Vertical field of view: a long lens, which keeps limbs in proportion. */
export const LENS_DEGREES = 23;

const EYE_ELEVATION_RAD = 0.07;
/** Not quite from above, so that the picture has an upper edge. */
const TOP_ELEVATION_RAD = 1.555;
/** Half the height and half the width that the framing keeps free around the figure. */
const FRAMED_HALF_HEIGHT = 0.67;
const FRAMED_HALF_WIDTH = 0.6;
/** A ghost may come nearer to the edge. */
const GHOST_HALF_WIDTH = 0.5;
const TARGET_HEIGHT = 0.54;
/** How much wider the picture may become for the ghosts. */
const MOST_ROOM = 1.5;

export interface Yaws {
  readonly frontYawRad: number;
  readonly sideYawRad: number;
}

/** Where the figures stand: their middle, how far the outermost is from it, how far they reach above and below a standing human. */
export interface Place {
  readonly x: number;
  readonly z: number;
  readonly reach: number;
  readonly above: number;
  readonly below: number;
  /** How far the farthest ghost is from their middle. */
  readonly ghosts: number;
}

/** What of a view follows the figures: where it looks and from how far away. */
export type Framing = Pick<View, 'distance' | 'targetX' | 'targetY' | 'targetZ'>;

/** A view beside what was framed for the camera: the same stance can be taken before other figures, in another shape. */
export interface Stance {
  readonly framed: Framing;
  /** Width / height of the picture it was framed for. */
  readonly aspect: number;
  readonly yawRad: number;
  readonly elevationRad: number;
  /** How many times as far away as framed. */
  readonly zoom: number;
  readonly offsetX: number;
  readonly offsetY: number;
  readonly offsetZ: number;
}

export function viewOf(stance: Stance, framed: Framing): View {
  const { yawRad, elevationRad, zoom, offsetX, offsetY, offsetZ } = stance;
  return {
    yawRad,
    elevationRad,
    distance: framed.distance * zoom,
    targetX: framed.targetX + offsetX,
    targetY: framed.targetY + offsetY,
    targetZ: framed.targetZ + offsetZ,
  };
}

/** Where the eye is. */
export function eyeOf(view: View): { readonly x: number; readonly y: number; readonly z: number } {
  const flat = view.distance * Math.cos(view.elevationRad);
  return {
    x: view.targetX + flat * Math.sin(view.yawRad),
    y: view.targetY + view.distance * Math.sin(view.elevationRad),
    z: view.targetZ + flat * Math.cos(view.yawRad),
  };
}

/** The preset's view of the figures; `aspect` is width / height of the stage. */
export function presetView(
  preset: ViewPreset,
  yaws: Yaws,
  aspect: number,
  place: Place,
  headroom = 0,
  room: number | null = null,
): View {
  return {
    yawRad: preset === 'side' ? yaws.sideYawRad : yaws.frontYawRad,
    elevationRad: preset === 'top' ? TOP_ELEVATION_RAD : EYE_ELEVATION_RAD,
    ...framing(aspect, place, headroom, room),
  };
}

/**
 * Where a camera looks and how far away it stands, so that all figures are in the picture.
 * `headroom`: part of the stage's height that is kept free above, for what stands over it. `room`: how
 * many times as much is shown as the figures need, wherever ghosts are; null: what the ghosts ask for.
 */
export function framing(
  aspect: number,
  place: Place,
  headroom = 0,
  room: number | null = null,
): Framing {
  const { x, z, reach, above, below, ghosts } = place;
  const shape = Math.max(aspect, 1e-3);
  const halfWidth = FRAMED_HALF_WIDTH + reach;
  const halfHeight = FRAMED_HALF_HEIGHT + (above + below) / 2;
  const alone = Math.max(halfHeight, halfWidth / shape);
  // Ghosts far away do not make the figure small.
  const asked = Math.min((GHOST_HALF_WIDTH + ghosts) / shape, alone * MOST_ROOM);
  const free = Math.max(alone, room === null ? asked : alone * room);
  const half = free / (1 - headroom);
  return {
    // The nearest of several figures may stand before the middle.
    distance: half / Math.tan((LENS_DEGREES * Math.PI) / 360) + reach,
    targetX: x,
    targetY: TARGET_HEIGHT + (above - below) / 2 + half * headroom,
    targetZ: z,
  };
}

/** Writes the view at `progress` 0 … 1 between two views into `out`, turning the shorter way. */
export function mixViews(from: View, to: View, progress: number, out: View): void {
  const mix = (a: number, b: number): number => a + (b - a) * progress;
  out.yawRad = from.yawRad + shortestTurn(from.yawRad, to.yawRad) * progress;
  out.elevationRad = mix(from.elevationRad, to.elevationRad);
  out.distance = mix(from.distance, to.distance);
  out.targetX = mix(from.targetX, to.targetX);
  out.targetY = mix(from.targetY, to.targetY);
  out.targetZ = mix(from.targetZ, to.targetZ);
}

/** The turn from one yaw to another, between −π and π. */
export function shortestTurn(fromRad: number, toRad: number): number {
  const turn = (toRad - fromRad) % (2 * Math.PI);
  if (turn > Math.PI) return turn - 2 * Math.PI;
  return turn < -Math.PI ? turn + 2 * Math.PI : turn;
}

/** Quick at first, gentle at the end; close to cubic-bezier(.2, 0, 0, 1). */
export function eased(progress: number): number {
  const left = 1 - Math.min(Math.max(progress, 0), 1);
  return 1 - left * left * left * left;
}
