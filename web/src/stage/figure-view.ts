/** In: a range of cones in the cone texture. Out: a figure, drawn in one instanced call. */
import {
  Color,
  GLSL3,
  type IUniform,
  Mesh,
  ShaderMaterial,
  type ShaderMaterialParameters,
} from 'three';
import { coneGeometry } from './cone-geometry';
import type { BodyColours, Palette } from './palette';
import { figureFragment, figureVertex } from './shaders';

/** Uniforms that all figures and the ground share. */
export type SharedUniforms = Record<'cones' | 'sunDirection', IUniform>;

/** What is drawn of a figure; it may change from frame to frame. */
export interface FigureLook {
  readonly first: number;
  readonly count: number;
  /** What the stencil holds where it is drawn, if its matter writes there. */
  readonly mark: number;
  /** In a leading rest frame, which is greyed. */
  resting: boolean;
  /** Whether the figure darkens itself. */
  occluded: boolean;
  /** All of it in this colour of `Palette.tints`; null: in those of its sides. */
  readonly tint: number | null;
}

/** The matter of figures: one shader program, compiled once for all clips. */
export class FigureMaterial extends ShaderMaterial {
  private sides: BodyColours = [new Color(), new Color(), new Color()];
  private tints: readonly BodyColours[] = [];

  constructor(shared: SharedUniforms, parameters: ShaderMaterialParameters = {}) {
    super({
      glslVersion: GLSL3,
      vertexShader: figureVertex,
      fragmentShader: figureFragment,
      ...parameters,
      uniforms: {
        ...shared,
        firstCone: { value: 0 },
        occluderCount: { value: 0 },
        opacity: { value: 1 },
        resting: { value: 0 },
        restColour: { value: new Color() },
        sideColours: { value: [new Color(), new Color(), new Color()] },
        sky: { value: null },
        ground: { value: null },
        sun: { value: null },
        rim: { value: null },
      },
    });
  }

  coloursOf({ tint }: FigureLook): BodyColours {
    return tint === null || this.tints.length === 0
      ? this.sides
      : this.tints[tint % this.tints.length];
  }

  setPalette({ left, right, trunk, tints, rest, lighting }: Palette): void {
    const { uniforms } = this;
    this.sides = [left, right, trunk];
    this.tints = tints;
    uniforms.sideColours.value = this.sides;
    uniforms.restColour.value = rest;
    uniforms.sky.value = lighting.sky;
    uniforms.ground.value = lighting.ground;
    uniforms.sun.value = lighting.sun;
    uniforms.rim.value = lighting.rim;
  }
}

/** The mesh of a figure in the matter given; `look` is read whenever it is drawn. */
export function figureMesh(material: FigureMaterial, look: FigureLook): Mesh {
  const mesh = new Mesh(coneGeometry(look.count), material);
  mesh.frustumCulled = false;
  mesh.onBeforeRender = () => {
    const { uniforms } = material;
    uniforms.firstCone.value = look.first;
    uniforms.sideColours.value = material.coloursOf(look);
    uniforms.occluderCount.value = look.occluded ? look.count : 0;
    uniforms.resting.value = look.resting ? 1 : 0;
    material.stencilRef = look.mark;
    material.uniformsNeedUpdate = true;
  };
  return mesh;
}
