/** In: poses around a keypose, chosen joints. Out: the joints' paths in the scene, and where the playhead is on them. */
import type { FigurePose } from './figure-pose';
import type { StageTrails } from './stage-props';
import type { TrailPath } from './trail-geometry';
import { SIDE_NUMBER } from './cone-texture';

export function trailPaths(
  { joints, frames, poses }: StageTrails,
  figure: FigurePose,
): TrailPath[] {
  const width = figure.joints.length;
  if (frames.length < 2 || poses.length !== frames.length * width) return [];
  const times = Float32Array.from(frames, (frame) => trailTime(frames, frame));
  const inside = [...joints].filter((joint) => joint >= 0 && joint * 3 < width);
  const paths = inside.map((joint) => ({
    joint,
    points: new Float32Array(frames.length * 3),
    times,
    side: sideOf(figure, joint),
  }));
  const places = new Float32Array(width);
  for (let i = 0; i < frames.length; i++) {
    figure.placesOf(poses.subarray(i * width, (i + 1) * width), places);
    for (const { joint, points } of paths) {
      for (let axis = 0; axis < 3; axis++) points[i * 3 + axis] = places[joint * 3 + axis];
    }
  }
  return paths;
}

/** From 0 at the first frame to 1 at the last. */
export function trailTime(frames: Int32Array, frame: number): number {
  const first = frames[0];
  const length = frames[frames.length - 1] - first;
  return length > 0 ? Math.min(Math.max((frame - first) / length, 0), 1) : 0;
}

/** The colour of the bone that ends in the joint, or begins there. */
function sideOf({ bones }: FigurePose, joint: number): number {
  const ending = bones.find(({ end }) => end.from === joint && end.to === joint);
  const bone = ending ?? bones.find(({ start }) => start.from === joint && start.to === joint);
  return SIDE_NUMBER[bone?.side ?? 'trunk'];
}
