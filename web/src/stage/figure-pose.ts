/** In: a performer and its poses. Out: its rounded cones in the scene, written into the cone texture. */
import { type BoneCone, writeCones } from '../figure/bone-cone';
import { figureBones, mirroredBones } from '../figure/figure-bones';
import { place, type Placement } from '../figure/placement';
import { type FigurePerformer, type SceneFrame, toScene } from '../figure/up-frame';
import { type ConeTexture, TEXTURE_STRIDE } from './cone-texture';

/** Length of the shadow of a height, for the stage's sun; width of the shade around a body. */
const SHADOW_OF_HEIGHT = 0.75;
const SHADE_WIDTH = 0.5;
/** A human's joints lie within these around the pelvis and above the ground, nearly always, in body heights. */
const HUMAN_REACH = 0.55;
const HUMAN_HIGH = 1.12;
const HUMAN_LOW = -0.1;
/** A joint gone astray does not make the rest a dot. */
const MOST_EXCESS = 3;
/** Beyond as many body heights the graphics' numbers are too coarse for a figure. */
const FARTHEST = 1e5;

/** A performer, and where it stands if not where it was recorded. */
export interface PlacedPerformer extends FigurePerformer {
  readonly placement?: Placement;
}

/** One performer's figure in the scene, pose by pose. */
export class FigurePose {
  readonly joints: Float32Array;
  readonly bones: readonly BoneCone[];
  /** Body height in those of the scene. */
  readonly radiusScale: number;
  private readonly performer: PlacedPerformer;
  private readonly frame: SceneFrame;
  private readonly pelvis: number;
  private readonly human: boolean;
  /** How far from its pelvis the figure shades the ground. */
  groundReach = 0;
  /** Height of its highest joint. */
  top = 0;
  /** Where its middle is over the ground: a human's pelvis, the mean of another body's joints. */
  middleX = 0;
  middleZ = 0;
  /** How far it reaches beyond a standing human around its middle, above and below: the most so far, so that the picture does not breathe. */
  excess = 0;
  excessHigh = 0;
  excessLow = 0;

  /** `frame` is the clip's; the bones are laid out by the first pose, unless they are given. */
  constructor(
    performer: PlacedPerformer,
    frame: SceneFrame,
    pose: Float32Array,
    bones?: readonly BoneCone[],
  ) {
    this.performer = performer;
    this.frame = frame;
    this.joints = new Float32Array(pose.length);
    this.pelvis = Math.max(0, performer.body.pelvis);
    this.human = performer.body.kind === 'human';
    const height = performer.body.height;
    this.radiusScale = height > 0 ? height / frame.bodyHeight : 1;
    toScene(pose, { ...frame, bodyHeight: frame.bodyHeight * this.radiusScale }, this.joints);
    this.bones = bones ?? bonesOf(performer, this.joints);
  }

  /** Writes the pose's cones into `texture` from cone number `first`; false if it has no place in the picture. */
  writePose(pose: Float32Array, texture: ConeTexture, first: number): boolean {
    this.placesOf(pose, this.joints);
    if (!isDrawable(this.joints)) return false;
    writeCones(
      this.bones,
      this.joints,
      this.radiusScale,
      texture.data,
      first * TEXTURE_STRIDE,
      TEXTURE_STRIDE,
    );
    this.measure();
    return true;
  }

  /** Another figure of the same body. */
  twin(): FigurePose {
    return new FigurePose(this.performer, this.frame, this.joints, this.bones);
  }

  /** Writes the places of the joints in another pose into `out`. */
  placesOf(pose: ArrayLike<number>, out: Float32Array): void {
    toScene(pose, this.frame, out);
    if (this.performer.placement) place(out, this.performer.placement);
  }

  get x(): number {
    return this.joints[this.pelvis * 3];
  }

  get z(): number {
    return this.joints[this.pelvis * 3 + 2];
  }

  private measure(): void {
    const { joints, x, z } = this;
    let reach = 0;
    let top = 0;
    let bottom = 0;
    for (let i = 0; i < joints.length; i += 3) {
      reach = Math.max(reach, Math.hypot(joints[i] - x, joints[i + 2] - z));
      top = Math.max(top, joints[i + 1]);
      bottom = Math.min(bottom, joints[i + 1]);
    }
    this.top = top;
    this.groundReach = reach + SHADOW_OF_HEIGHT * top + SHADE_WIDTH;
    this.findMiddle();
    this.excessHigh = wider(this.excessHigh, this.human ? top - HUMAN_HIGH : top - 1);
    this.excessLow = wider(this.excessLow, this.human ? HUMAN_LOW - bottom : -bottom);
    if (!this.human) this.excess = wider(this.excess, this.reachOfMiddle() - HUMAN_REACH);
  }

  private findMiddle(): void {
    const { joints } = this;
    this.middleX = this.x;
    this.middleZ = this.z;
    if (this.human) return;
    let [sumX, sumZ] = [0, 0];
    for (let i = 0; i < joints.length; i += 3) {
      sumX += joints[i];
      sumZ += joints[i + 2];
    }
    this.middleX = (3 * sumX) / joints.length;
    this.middleZ = (3 * sumZ) / joints.length;
  }

  private reachOfMiddle(): number {
    const { joints, middleX, middleZ } = this;
    let reach = 0;
    for (let i = 0; i < joints.length; i += 3)
      reach = Math.max(reach, Math.hypot(joints[i] - middleX, joints[i + 2] - middleZ));
    return reach;
  }
}

function bonesOf({ skeleton, body, placement }: PlacedPerformer, joints: Float32Array): BoneCone[] {
  const bones = figureBones(skeleton, body, joints);
  return placement?.mirrored ? mirroredBones(bones) : bones;
}

/** Every joint is at a place that graphics can show. */
function isDrawable(joints: Float32Array): boolean {
  for (let i = 0; i < joints.length; i++) if (!(Math.abs(joints[i]) < FARTHEST)) return false;
  return true;
}

function wider(excess: number, now: number): number {
  return Math.max(excess, Math.min(now, MOST_EXCESS));
}
