/** In: a performer and its poses. Out: its cones in the shared texture and one instanced draw. */
import { Color, GLSL3, type IUniform, Mesh, ShaderMaterial } from 'three';
import { type BoneCone, writeCones } from '../figure/bone-cone';
import { figureBones } from '../figure/figure-bones';
import { type FigurePerformer, type SceneFrame, toScene } from '../figure/up-frame';
import { coneGeometry } from './cone-geometry';
import { type ConeTexture, TEXTURE_STRIDE } from './cone-texture';
import type { Palette } from './palette';
import { figureFragment, figureVertex } from './shaders';

/** Uniforms that all figures and the ground share. */
export type SharedUniforms = Record<'cones' | 'sunDirection', IUniform>;

/** The figure's own scene coordinates before it is drawn. */
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

/** The mesh of one figure. */
export class FigureView {
  readonly mesh: Mesh;
  private readonly material: ShaderMaterial;

  constructor(cones: number, first: number, shared: SharedUniforms) {
    this.material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: figureVertex,
      fragmentShader: figureFragment,
      uniforms: {
        ...shared,
        firstCone: { value: first },
        coneCount: { value: cones },
        sideColours: { value: [new Color(), new Color(), new Color()] },
        sky: { value: null },
        ground: { value: null },
        sun: { value: null },
        rim: { value: null },
      },
    });
    this.mesh = new Mesh(coneGeometry(cones), this.material);
    this.mesh.frustumCulled = false;
  }

  setPalette({ left, right, trunk, lighting }: Palette): void {
    const { uniforms } = this.material;
    uniforms.sideColours.value = [left, right, trunk];
    uniforms.sky.value = lighting.sky;
    uniforms.ground.value = lighting.ground;
    uniforms.sun.value = lighting.sun;
    uniforms.rim.value = lighting.rim;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.material.dispose();
  }
}
