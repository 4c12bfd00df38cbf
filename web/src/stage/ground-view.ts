/** In: where figures stand, the grid's cell. Out: grid and contact shadows on one large square. */
import { GLSL3, Mesh, PlaneGeometry, ShaderMaterial, Vector2 } from 'three';
import type { SharedUniforms } from './figure-view';
import type { Palette } from './palette';
import { groundFragment, groundVertex, MOST_SPOTS, NEAR_FIGURES } from './shaders';

/** The grid has faded at this many body heights. */
const FADE = 4.1;
/** Side of the square, in body heights: farther than a figure may be while it is still seen. */
const SIZE = 60;
/** Radius and strength of the soft spot under a figure that is not among the nearest. */
const SPOT_RADIUS = 0.22;
const SPOT_STRENGTH = 0.5;

/** What the ground has to know of a figure. */
export interface GroundFigure {
  readonly first: number;
  readonly count: number;
  readonly x: number;
  readonly z: number;
  readonly groundReach: number;
  /** How much of its shade falls, from 0 to 1. */
  readonly weight: number;
}

export class GroundView {
  readonly mesh: Mesh;
  private readonly material: ShaderMaterial;
  /** First cone and count; x, z, radius; x, z, radius: flat, as WebGL takes them. */
  private readonly ranges = new Int32Array(NEAR_FIGURES * 2);
  private readonly bounds = new Float32Array(NEAR_FIGURES * 3);
  private readonly weights = new Float32Array(NEAR_FIGURES);
  private readonly spots = new Float32Array(MOST_SPOTS * 4);
  /** The figures, the nearest to the first one first. */
  private readonly near: GroundFigure[] = [];
  private readonly centre = new Vector2();

  constructor(shared: SharedUniforms) {
    this.material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: groundVertex,
      fragmentShader: groundFragment,
      transparent: true,
      depthWrite: false,
      uniforms: {
        ...shared,
        figures: { value: this.ranges },
        figureBounds: { value: this.bounds },
        figureWeights: { value: this.weights },
        figureCount: { value: 0 },
        spots: { value: this.spots },
        spotCount: { value: 0 },
        centre: { value: this.centre },
        cell: { value: 0.5 },
        fade: { value: FADE },
        pixelRatio: { value: 1 },
        gridStrength: { value: 0 },
        shadowStrength: { value: 0 },
        gridColour: { value: null },
        shadowColour: { value: null },
      },
    });
    this.mesh = new Mesh(new PlaneGeometry(SIZE, SIZE).rotateX(-Math.PI / 2), this.material);
    this.mesh.renderOrder = -1;
    this.mesh.frustumCulled = false;
  }

  setPalette({ grid, shadow, lighting }: Palette): void {
    const { uniforms } = this.material;
    uniforms.gridColour.value = grid;
    uniforms.shadowColour.value = shadow;
    uniforms.gridStrength.value = lighting.gridStrength;
    uniforms.shadowStrength.value = lighting.shadowStrength;
  }

  /** Side of the grid's cells, in body heights. */
  setCell(cell: number): void {
    this.material.uniforms.cell.value = cell;
  }

  /** Device pixels of one CSS pixel. */
  setPixelRatio(ratio: number): void {
    this.material.uniforms.pixelRatio.value = ratio;
  }

  /** The middle of the grid. */
  setCentre(x: number, z: number): void {
    this.centre.set(x, z);
    this.mesh.position.set(x, 0, z);
  }

  /** The first figure and the nearest to it are seen cone by cone, the others as soft spots. */
  setFigures(figures: readonly GroundFigure[]): void {
    const { near } = this;
    near.length = 0;
    for (let i = 0; i < figures.length; i++) near.push(figures[i]);
    bringNearestForward(near, NEAR_FIGURES);
    const count = Math.min(near.length, NEAR_FIGURES);
    const spots = Math.min(near.length - count, MOST_SPOTS);
    for (let i = 0; i < count; i++) this.setNear(i, near[i]);
    for (let i = 0; i < spots; i++) this.setSpot(i, near[count + i]);
    this.material.uniforms.figureCount.value = count;
    this.material.uniforms.spotCount.value = spots;
  }

  private setNear(i: number, { first, count, x, z, groundReach, weight }: GroundFigure): void {
    this.ranges[i * 2] = first;
    this.ranges[i * 2 + 1] = count;
    this.bounds[i * 3] = x;
    this.bounds[i * 3 + 1] = z;
    this.bounds[i * 3 + 2] = groundReach;
    this.weights[i] = weight;
  }

  private setSpot(i: number, { x, z, weight }: GroundFigure): void {
    this.spots[i * 4] = x;
    this.spots[i * 4 + 1] = z;
    this.spots[i * 4 + 2] = SPOT_RADIUS;
    this.spots[i * 4 + 3] = SPOT_STRENGTH * weight;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.material.dispose();
  }
}

/** Exchanges figures so that the `count` nearest to the first one, itself included, come first. */
function bringNearestForward(figures: GroundFigure[], count: number): void {
  for (let place = 1; place < Math.min(count, figures.length); place++) {
    let nearest = place;
    for (let i = place + 1; i < figures.length; i++) {
      if (apart(figures[0], figures[i]) < apart(figures[0], figures[nearest])) nearest = i;
    }
    [figures[place], figures[nearest]] = [figures[nearest], figures[place]];
  }
}

function apart(a: GroundFigure, b: GroundFigure): number {
  return Math.hypot(a.x - b.x, a.z - b.z);
}
