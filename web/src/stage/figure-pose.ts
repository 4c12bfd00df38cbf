/** In: a performer and its poses. Out: its rounded cones in the scene, written into the cone texture. */
import { type BoneCone, writeCones } from '../figure/bone-cone';
import { figureBones } from '../figure/figure-bones';
import { type FigurePerformer, type SceneFrame, toScene } from '../figure/up-frame';
import { type ConeTexture, TEXTURE_STRIDE } from './cone-texture';

/** One performer's figure in the scene, pose by pose. */
export class FigurePose {
  readonly joints: Float32Array;
  readonly bones: readonly BoneCone[];
  private readonly frame: SceneFrame;
  private readonly radiusScale: number;
  private readonly pelvis: number;

  /** `frame` is the clip's; the bones are laid out by the first pose. */
  constructor(performer: FigurePerformer, frame: SceneFrame, pose: Float32Array) {
    this.frame = frame;
    this.joints = new Float32Array(pose.length);
    this.pelvis = Math.max(0, performer.body.pelvis);
    const height = performer.body.height;
    this.radiusScale = height > 0 ? height / frame.bodyHeight : 1;
    toScene(pose, { ...frame, bodyHeight: frame.bodyHeight * this.radiusScale }, this.joints);
    this.bones = figureBones(performer.skeleton, performer.body, this.joints);
  }

  /** Writes the pose's cones into `texture` from cone number `first`. */
  writePose(pose: Float32Array, texture: ConeTexture, first: number): void {
    toScene(pose, this.frame, this.joints);
    writeCones(
      this.bones,
      this.joints,
      this.radiusScale,
      texture.data,
      first * TEXTURE_STRIDE,
      TEXTURE_STRIDE,
    );
  }

  get x(): number {
    return this.joints[this.pelvis * 3];
  }

  get z(): number {
    return this.joints[this.pelvis * 3 + 2];
  }

  /** How far the figure reaches from its pelvis along the ground, with the shadow it throws. */
  get groundReach(): number {
    let reach = 0;
    let top = 0;
    const { joints, x, z } = this;
    for (let i = 0; i < joints.length; i += 3) {
      reach = Math.max(reach, Math.abs(joints[i] - x), Math.abs(joints[i + 2] - z));
      top = Math.max(top, joints[i + 1]);
    }
    return 1.42 * reach + 0.75 * top + 0.5;
  }
}
