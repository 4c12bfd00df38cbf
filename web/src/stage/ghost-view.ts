/** In: a range of cones in the cone texture. Out: a figure seen through, without the edges inside it. */
import { type Mesh, NotEqualStencilFunc, ReplaceStencilOp, type Scene } from 'three';
import type { FigurePose } from './figure-pose';
import { figureMesh, type FigureLook, FigureMaterial, type SharedUniforms } from './figure-view';
import type { GroundFigure } from './ground-view';
import type { Palette } from './palette';
import { depthFragment } from './shaders';

const OPACITY = 0.28;
const CONTRAST_OPACITY = 0.45;
/** Ghosts shade the ground less than what is there. */
const SHADE = 0.5;
/** Above ground and trails. */
const FIRST_ORDER = 2;

/** What all ghosts are made of: their nearest surface by the first, its colour by the second. */
export class GhostMatter {
  readonly veil: FigureMaterial;
  readonly skin: FigureMaterial;

  constructor(shared: SharedUniforms) {
    // "transparent" puts both among what is drawn last.
    const last = { transparent: true };
    this.veil = new FigureMaterial(shared, {
      ...last,
      fragmentShader: depthFragment,
      colorWrite: false,
    });
    // Where two cones lie in the same depth the colour comes once all the same: the stencil tells.
    this.skin = new FigureMaterial(shared, {
      ...last,
      depthWrite: false,
      stencilWrite: true,
      stencilFunc: NotEqualStencilFunc,
      stencilZPass: ReplaceStencilOp,
    });
    this.setContrast(false);
  }

  setPalette(palette: Palette): void {
    this.veil.setPalette(palette);
    this.skin.setPalette(palette);
  }

  setContrast(more: boolean): void {
    this.skin.uniforms.opacity.value = more ? CONTRAST_OPACITY : OPACITY;
  }

  dispose(): void {
    this.veil.dispose();
    this.skin.dispose();
  }
}

/** One ghost, hidden until it is shown. */
export class GhostView implements GroundFigure {
  readonly pose: FigurePose;
  readonly first: number;
  readonly count: number;
  readonly weight = SHADE;
  /** Here for a moment only. */
  passing = false;
  groundReach = 0;
  /** From the eye over the ground. */
  distance = 0;
  x = 0;
  z = 0;
  private readonly look: FigureLook;
  private readonly meshes: readonly [Mesh, Mesh];

  /** `mark`: from 1, another for every ghost; `tint`: its figure's. */
  constructor(
    matter: GhostMatter,
    pose: FigurePose,
    first: number,
    mark: number,
    tint: number | null,
  ) {
    this.pose = pose;
    this.first = first;
    this.count = pose.bones.length;
    this.look = { first, count: this.count, resting: false, occluded: true, mark, tint };
    this.meshes = [figureMesh(matter.veil, this.look), figureMesh(matter.skin, this.look)];
    this.visible = false;
  }

  get visible(): boolean {
    return this.meshes[0].visible;
  }
  set visible(visible: boolean) {
    for (const mesh of this.meshes) mesh.visible = visible;
  }

  set occluded(occluded: boolean) {
    this.look.occluded = occluded;
  }

  /** Of several ghosts the one with the lower number is drawn first. */
  set order(order: number) {
    this.meshes[0].renderOrder = FIRST_ORDER + order * 2;
    this.meshes[1].renderOrder = FIRST_ORDER + order * 2 + 1;
  }

  /** Takes over what the ground has to know of its pose. */
  place(): void {
    this.x = this.pose.x;
    this.z = this.pose.z;
    this.groundReach = this.pose.groundReach;
  }

  addTo(scene: Scene): void {
    scene.add(...this.meshes);
  }

  removeFrom(scene: Scene): void {
    scene.remove(...this.meshes);
    for (const mesh of this.meshes) mesh.geometry.dispose();
  }
}
