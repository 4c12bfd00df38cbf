/** In: the stage's two colours. Out: a gradient behind everything. */
import { BufferAttribute, BufferGeometry, GLSL3, Mesh, ShaderMaterial } from 'three';
import type { Palette } from './palette';
import { backgroundFragment, backgroundVertex } from './shaders';

export class BackgroundView {
  readonly mesh: Mesh;
  private readonly material = new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: backgroundVertex,
    fragmentShader: backgroundFragment,
    depthTest: false,
    depthWrite: false,
    uniforms: { top: { value: null }, bottom: { value: null } },
  });

  constructor() {
    const geometry = new BufferGeometry();
    // One triangle that covers the screen.
    geometry.setAttribute(
      'position',
      new BufferAttribute(Float32Array.of(-1, -1, 0, 3, -1, 0, -1, 3, 0), 3),
    );
    this.mesh = new Mesh(geometry, this.material);
    this.mesh.renderOrder = -2;
    this.mesh.frustumCulled = false;
  }

  setPalette({ stageTop, stageBottom }: Palette): void {
    this.material.uniforms.top.value = stageTop;
    this.material.uniforms.bottom.value = stageBottom;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.material.dispose();
  }
}
