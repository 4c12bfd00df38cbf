/** In: performers, their poses, a palette. Out: the three.js scene: background, ground, figures. */
import { type Mesh, Scene } from 'three';
import type { PerformerResult } from '../engine/types';
import type { PoseSource } from '../engine/pose-source';
import { type FigurePerformer, type SceneFrame, sceneFrameOf } from '../figure/up-frame';
import { BackgroundView } from './background-view';
import { ConeTexture } from './cone-texture';
import { FigurePose } from './figure-pose';
import { figureMesh, FigureMaterial, type SharedUniforms } from './figure-view';
import { type GroundFigure, GroundView } from './ground-view';
import { type Palette, SUN_DIRECTION } from './palette';

/** One performer of the clip on the stage. */
export interface StagePerformer extends FigurePerformer {
  readonly unit: PerformerResult['unit'];
  readonly sideYawRad: number;
  readonly frontYawRad: number;
  readonly source: PoseSource;
}

/** Metres between the lines of the grid; in body heights where the unit is unknown. */
const CELL = 0.5;

interface Figure extends GroundFigure {
  readonly pose: FigurePose;
  readonly mesh: Mesh;
  x: number;
  z: number;
  groundReach: number;
}

export class StageScene {
  readonly scene = new Scene();
  /** Where the figures stand and how far beyond a standing human they reach, in body heights. */
  readonly place = { x: 0, z: 0, reach: 0, above: 0, below: 0 };
  private readonly background = new BackgroundView();
  private readonly shared: SharedUniforms = {
    cones: { value: null },
    sunDirection: { value: SUN_DIRECTION },
  };
  private readonly ground = new GroundView(this.shared);
  private cones = new ConeTexture(0);
  private performers: readonly StagePerformer[] = [];
  private figures: Figure[] = [];
  /** The figures are those of former performers. */
  private outdated = false;
  private readonly material = new FigureMaterial(this.shared);
  /** Draws nothing, but has the figures' shader compiled before the first figure comes. */
  private readonly herald = figureMesh(this.material, 0, 0);

  constructor() {
    this.scene.add(this.background.mesh, this.ground.mesh, this.herald);
    this.shared.cones.value = this.cones.texture;
  }

  /** The figures of the performers are there, and the place is theirs. */
  get ready(): boolean {
    return this.figures.length > 0 && !this.outdated;
  }

  setPalette(palette: Palette): void {
    this.background.setPalette(palette);
    this.ground.setPalette(palette);
    this.material.setPalette(palette);
  }

  /** New figures take the place of the old ones with the first frame whose poses are there. */
  setPerformers(performers: readonly StagePerformer[]): void {
    this.performers = performers;
    this.outdated = true;
    if (performers.length === 0) this.removeFigures();
  }

  /** Shows a frame; false while poses are missing (the figures then stay as they were). */
  showFrame(frame: number): boolean {
    const { performers } = this;
    for (let i = 0; i < performers.length; i++) {
      if (poseAt(performers[i], frame) === null) return false;
    }
    if (this.outdated) this.replaceFigures(frame);
    for (let i = 0; i < this.figures.length; i++) {
      const pose = poseAt(performers[i], frame);
      if (pose !== null) this.figures[i].pose.writePose(pose, this.cones, this.figures[i].first);
    }
    this.cones.changed();
    this.placeFigures();
    return true;
  }

  setPixelRatio(ratio: number): void {
    this.ground.setPixelRatio(ratio);
  }

  /** The middle of the grid, where it does not fade. */
  setGridCentre(x: number, z: number): void {
    this.ground.setCentre(x, z);
  }

  dispose(): void {
    this.removeFigures();
    this.herald.geometry.dispose();
    this.material.dispose();
    this.cones.dispose();
    this.ground.dispose();
    this.background.dispose();
  }

  private replaceFigures(frame: number): void {
    this.removeFigures();
    this.outdated = false;
    if (this.performers.length === 0) return;
    this.ground.setCell(cellOf(this.performers[0]));
    const clipFrame = sceneFrameOf(this.performers[0]);
    const poses = this.performers.map((performer) => firstPose(performer, frame, clipFrame));
    this.setTexture(poses.reduce((sum, pose) => sum + pose.bones.length, 0));
    let first = 0;
    for (const pose of poses) {
      this.figures.push(this.createFigure(pose, first));
      first += pose.bones.length;
    }
  }

  private createFigure(pose: FigurePose, first: number): Figure {
    this.cones.setBones(pose.bones, first);
    const count = pose.bones.length;
    const mesh = figureMesh(this.material, first, count);
    this.scene.add(mesh);
    return { pose, mesh, first, count, x: 0, z: 0, groundReach: 0 };
  }

  private setTexture(cones: number): void {
    this.cones.dispose();
    this.cones = new ConeTexture(cones);
    this.shared.cones.value = this.cones.texture;
  }

  private placeFigures(): void {
    const { figures, place } = this;
    const share = 1 / Math.max(1, figures.length);
    place.x = place.z = place.reach = place.above = place.below = 0;
    for (const figure of figures) {
      figure.x = figure.pose.x;
      figure.z = figure.pose.z;
      figure.groundReach = figure.pose.groundReach;
      place.x += figure.pose.middleX * share;
      place.z += figure.pose.middleZ * share;
    }
    for (const { pose } of figures) {
      const away = Math.hypot(pose.middleX - place.x, pose.middleZ - place.z);
      place.reach = Math.max(place.reach, away + pose.excess);
      place.above = Math.max(place.above, pose.excessHigh);
      place.below = Math.max(place.below, pose.excessLow);
    }
    this.ground.setFigures(figures);
  }

  private removeFigures(): void {
    for (const { mesh } of this.figures) {
      this.scene.remove(mesh);
      mesh.geometry.dispose();
    }
    this.figures = [];
    this.ground.setFigures([]);
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

function cellOf(performer: StagePerformer): number {
  const { unit, body } = performer;
  return unit && body.height > 0 ? CELL / (unit.metres * body.height) : CELL;
}
