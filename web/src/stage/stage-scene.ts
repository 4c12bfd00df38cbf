/** In: performers, their poses, a palette. Out: the three.js scene: background, ground, figures. */
import { Scene } from 'three';
import type { PerformerResult } from '../engine/types';
import type { PoseSource } from '../engine/pose-source';
import { type FigurePerformer, type SceneFrame, sceneFrameOf } from '../figure/up-frame';
import { BackgroundView } from './background-view';
import { ConeTexture } from './cone-texture';
import { FigurePose, FigureView, type SharedUniforms } from './figure-view';
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
  readonly view: FigureView;
  x: number;
  z: number;
  groundReach: number;
}

export class StageScene {
  readonly scene = new Scene();
  /** Middle of the figures on the ground, in body heights. */
  centreX = 0;
  centreZ = 0;
  private readonly background = new BackgroundView();
  private readonly shared: SharedUniforms = {
    cones: { value: null },
    sunDirection: { value: SUN_DIRECTION },
  };
  private readonly ground = new GroundView(this.shared);
  private cones = new ConeTexture(0);
  private performers: readonly StagePerformer[] = [];
  private figures: Figure[] = [];
  private palette: Palette | null = null;

  constructor() {
    this.scene.add(this.background.mesh, this.ground.mesh);
    this.shared.cones.value = this.cones.texture;
  }

  get hasFigures(): boolean {
    return this.figures.length > 0;
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.background.setPalette(palette);
    this.ground.setPalette(palette);
    for (const figure of this.figures) figure.view.setPalette(palette);
  }

  /** Figures appear with the first frame whose poses are there. */
  setPerformers(performers: readonly StagePerformer[]): void {
    this.removeFigures();
    this.performers = performers;
    if (performers.length > 0) this.ground.setCell(cellOf(performers[0]));
  }

  /** Shows a frame; false while poses are missing (the figures then stay as they were). */
  showFrame(frame: number): boolean {
    const { performers } = this;
    for (let i = 0; i < performers.length; i++) {
      if (poseAt(performers[i], frame) === null) return false;
    }
    if (this.figures.length === 0 && performers.length > 0) this.addFigures(frame);
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
    this.cones.dispose();
    this.ground.dispose();
    this.background.dispose();
  }

  private addFigures(frame: number): void {
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
    const view = new FigureView(pose.bones.length, first, this.shared);
    if (this.palette) view.setPalette(this.palette);
    this.scene.add(view.mesh);
    const count = pose.bones.length;
    return { pose, view, first, count, x: 0, z: 0, groundReach: 0 };
  }

  private setTexture(cones: number): void {
    this.cones.dispose();
    this.cones = new ConeTexture(cones);
    this.shared.cones.value = this.cones.texture;
  }

  private placeFigures(): void {
    const { figures } = this;
    let x = 0;
    let z = 0;
    for (const figure of figures) {
      figure.x = figure.pose.x;
      figure.z = figure.pose.z;
      figure.groundReach = figure.pose.groundReach;
      x += figure.x;
      z += figure.z;
    }
    this.centreX = x / Math.max(1, figures.length);
    this.centreZ = z / Math.max(1, figures.length);
    this.ground.setFigures(figures);
  }

  private removeFigures(): void {
    for (const { view } of this.figures) {
      this.scene.remove(view.mesh);
      view.dispose();
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
