/** In: a range of cones in the cone texture. Out: a figure, drawn in one instanced call. */
import { Color, GLSL3, type IUniform, Mesh, ShaderMaterial } from 'three';
import { coneGeometry } from './cone-geometry';
import type { Palette } from './palette';
import { figureFragment, figureVertex } from './shaders';

/** Uniforms that all figures and the ground share. */
export type SharedUniforms = Record<'cones' | 'sunDirection', IUniform>;

/** The matter of all figures: one shader program, compiled once for all clips. */
export class FigureMaterial extends ShaderMaterial {
  constructor(shared: SharedUniforms) {
    super({
      glslVersion: GLSL3,
      vertexShader: figureVertex,
      fragmentShader: figureFragment,
      uniforms: {
        ...shared,
        firstCone: { value: 0 },
        coneCount: { value: 0 },
        sideColours: { value: [new Color(), new Color(), new Color()] },
        sky: { value: null },
        ground: { value: null },
        sun: { value: null },
        rim: { value: null },
      },
    });
  }

  setPalette({ left, right, trunk, lighting }: Palette): void {
    const { uniforms } = this;
    uniforms.sideColours.value = [left, right, trunk];
    uniforms.sky.value = lighting.sky;
    uniforms.ground.value = lighting.ground;
    uniforms.sun.value = lighting.sun;
    uniforms.rim.value = lighting.rim;
  }
}

/** The mesh of a figure of `count` cones, the first of which has number `first`. */
export function figureMesh(material: FigureMaterial, first: number, count: number): Mesh {
  const mesh = new Mesh(coneGeometry(count), material);
  mesh.frustumCulled = false;
  mesh.onBeforeRender = () => {
    material.uniforms.firstCone.value = first;
    material.uniforms.coneCount.value = count;
    material.uniformsNeedUpdate = true;
  };
  return mesh;
}
