/** In: performers of one clip or of several, and their poses. Out: their figures in the scene, all in one cone texture. */
import type { Mesh, Scene } from 'three';
import type { PoseSource } from '../engine/pose-source';
import type { PerformerResult } from '../engine/types';
import { type SceneFrame, sceneFrameOf } from '../figure/up-frame';
import { ConeTexture } from './cone-texture';
import { FigurePose, type PlacedPerformer } from './figure-pose';
import {
  type FigureLook,
  figureMesh,
  type FigureMaterial,
  type SharedUniforms,
} from './figure-view';
import type { GroundFigure } from './ground-view';

/** One performer on the stage: of the one clip, or, placed there, of a clip of its own. */
export interface StagePerformer extends PlacedPerformer {
  readonly unit: PerformerResult['unit'];
  readonly sideYawRad: number;
  readonly frontYawRad: number;
  readonly leadingRestFrames: number;
  readonly source: PoseSource;
  /** Wears this colour of `Palette.tints` instead of those of its sides. */
  readonly tint?: number;
}

/** The frame of all performers, or of each its own. */
export type Frames = number | ArrayLike<number>;

export function frameOf(frames: Frames, performer: number): number {
  return typeof frames === 'number' ? frames : (frames[performer] ?? 0);
}

export interface Figure extends GroundFigure, FigureLook {
  readonly pose: FigurePose;
  readonly mesh: Mesh;
  /** Its pose has a place in the picture. */
  drawable: boolean;
  x: number;
  z: number;
  groundReach: number;
}

export class FigureSet {
  figures: readonly Figure[] = [];
  cones = new ConeTexture(0);
  private performers: readonly StagePerformer[] = [];
  private readonly scene: Scene;
  private readonly material: FigureMaterial;
  private readonly shared: SharedUniforms;

  constructor(scene: Scene, material: FigureMaterial, shared: SharedUniforms) {
    this.scene = scene;
    this.material = material;
    this.shared = shared;
    shared.cones.value = this.cones.texture;
  }

  /** Number of the first cone that is no performer's. */
  get spare(): number {
    return this.figures.reduce((sum, { count }) => sum + count, 0);
  }

  /** New figures, laid out by their poses at a frame; there is room for `twins` more of the largest. */
  replace(performers: readonly StagePerformer[], frames: Frames, twins: number): void {
    this.clear();
    this.performers = performers;
    if (performers.length === 0) return;
    const clipFrame = sceneFrameOf(performers[0]);
    const poses = performers.map((performer, i) =>
      firstPose(
        performer,
        frameOf(frames, i),
        performer.placement ? sceneFrameOf(performer) : clipFrame,
      ),
    );
    const counts = poses.map(({ bones }) => bones.length);
    this.setTexture(counts.reduce((a, b) => a + b) + twins * Math.max(...counts));
    let first = 0;
    this.figures = poses.map((pose, i) => {
      const figure = this.create(pose, first, performers[i].tint ?? null);
      first += counts[i];
      return figure;
    });
  }

  /** Whether all poses of the frames are there. */
  has(performers: readonly StagePerformer[], frames: Frames): boolean {
    for (let i = 0; i < performers.length; i++) {
      if (poseAt(performers[i], frameOf(frames, i)) === null) return false;
    }
    return true;
  }

  showFrame(frames: Frames): void {
    for (let i = 0; i < this.figures.length; i++) {
      const figure = this.figures[i];
      const frame = frameOf(frames, i);
      const pose = poseAt(this.performers[i], frame);
      if (pose === null) continue;
      figure.drawable = figure.pose.writePose(pose, this.cones, figure.first);
      figure.mesh.visible = figure.drawable;
      figure.resting = frame < this.performers[i].leadingRestFrames;
      if (!figure.drawable) continue;
      figure.x = figure.pose.x;
      figure.z = figure.pose.z;
      figure.groundReach = figure.pose.groundReach;
    }
    this.cones.changed();
  }

  clear(): void {
    for (const { mesh } of this.figures) {
      this.scene.remove(mesh);
      mesh.geometry.dispose();
    }
    this.figures = [];
  }

  dispose(): void {
    this.clear();
    this.cones.dispose();
  }

  private create(pose: FigurePose, first: number, tint: number | null): Figure {
    this.cones.setBones(pose.bones, first);
    const count = pose.bones.length;
    const look = { first, count, resting: false, occluded: true, mark: 0, tint };
    const place = { x: 0, z: 0, groundReach: 0, weight: 1, drawable: true };
    const figure: Omit<Figure, 'mesh'> = { pose, ...look, ...place };
    const mesh = figureMesh(this.material, figure);
    this.scene.add(mesh);
    return Object.assign(figure, { mesh });
  }

  private setTexture(cones: number): void {
    this.cones.dispose();
    this.cones = new ConeTexture(cones);
    this.shared.cones.value = this.cones.texture;
  }
}

/** Performers of a clip can be of different lengths: a shorter one stays at its end. */
function poseAt({ source }: StagePerformer, frame: number): Float32Array | null {
  return source.read(Math.max(0, Math.min(frame, source.frames - 1)));
}

function firstPose(performer: StagePerformer, frame: number, clipFrame: SceneFrame): FigurePose {
  const pose = poseAt(performer, frame) ?? new Float32Array(performer.skeleton.parents.length * 3);
  return new FigurePose(performer, clipFrame, pose);
}
