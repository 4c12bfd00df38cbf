/** In: paths of joints around a keypose. Out: tubes that fade with age, all in one draw call. */
import { BufferAttribute, BufferGeometry, Color, GLSL3, Mesh, ShaderMaterial } from 'three';
import type { Palette } from './palette';
import { trailFragment, trailVertex } from './shaders';
import { type TrailPath, tubes } from './trail-geometry';

/** In body heights. */
const RADIUS = 0.006;

export class TrailView {
  readonly mesh: Mesh;
  private readonly material = new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: trailVertex,
    fragmentShader: trailFragment,
    transparent: true,
    depthWrite: false,
    uniforms: {
      sideColours: { value: [new Color(), new Color(), new Color()] },
      now: { value: 0 },
    },
  });

  constructor() {
    this.mesh = new Mesh(new BufferGeometry(), this.material);
    this.mesh.renderOrder = 1;
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  setPalette({ left, right, trunk }: Palette): void {
    this.material.uniforms.sideColours.value = [left, right, trunk];
  }

  /** `scale`: body height of the performer in those of the scene. */
  setPaths(paths: readonly TrailPath[], scale: number): void {
    this.mesh.geometry.dispose();
    const { positions, normals, times, sides, index } = tubes(paths, RADIUS * scale);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('normal', new BufferAttribute(normals, 3));
    geometry.setAttribute('time', new BufferAttribute(times, 1));
    geometry.setAttribute('side', new BufferAttribute(sides, 1));
    geometry.setIndex(new BufferAttribute(index, 1));
    this.mesh.geometry = geometry;
    this.mesh.visible = index.length > 0;
  }

  /** The playhead, from 0 at the first point to 1 at the last. */
  setNow(now: number): void {
    this.material.uniforms.now.value = Math.min(Math.max(now, 0), 1);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.material.dispose();
  }
}
