/** Radii of the figure's rounded cones, in body heights: [at the start, at the end] of each bone. */
export const RADII = {
  thigh: [0.043, 0.031],
  shin: [0.031, 0.02],
  foot: [0.02, 0.013],
  upperArm: [0.028, 0.022],
  forearm: [0.022, 0.015],
  hand: [0.015, 0.011],
  pelvis: [0.044, 0.044],
  shoulder: [0.05, 0.03],
  neck: [0.023, 0.023],
  head: [0.045, 0.046],
  other: [0.018, 0.018],
} as const satisfies Record<string, readonly [number, number]>;

/** Where the shoulders leave the trunk, as a fraction of the way from pelvis to neck. */
export const CHEST_FRACTION = 0.7;

/** Radius of the spine at fractions of the way from pelvis to neck. */
const SPINE_PROFILE: readonly (readonly [number, number])[] = [
  [0, 0.05],
  [0.35, 0.046],
  [CHEST_FRACTION, 0.052],
  [1, 0.024],
];

/** Radius of the spine, in body heights, at a fraction 0 … 1 of the way from pelvis to neck. */
export function spineRadius(fraction: number): number {
  for (let i = 1; i < SPINE_PROFILE.length; i++) {
    const [from, fromRadius] = SPINE_PROFILE[i - 1];
    const [to, toRadius] = SPINE_PROFILE[i];
    if (fraction <= to)
      return fromRadius + ((toRadius - fromRadius) * (fraction - from)) / (to - from);
  }
  return SPINE_PROFILE[SPINE_PROFILE.length - 1][1];
}
