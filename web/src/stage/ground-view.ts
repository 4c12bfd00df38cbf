/** In: where figures stand, the grid's cell. Out: grid and contact shadows on one large square. */
import { GLSL3, Mesh, PlaneGeometry, ShaderMaterial, Vector2 } from 'three';
import type { SharedUniforms } from './figure-view';
import type { Palette } from './palette';
import { groundFragment, groundVertex, MOST_SPOTS, NEAR_FIGURES } from './shaders';

/** The grid has faded at this many body heights. */
const FADE = 4.1;
/** Side of the square, in body heights: farther than a figure may be while it is still seen. */
const SIZE = 60;
/** Radius of the soft spot under a figure that is not among the nearest. */
const SPOT_RADIUS = 0.22;

/** What the ground has to know of a figure. */
export interface GroundFigure {
  readonly first: number;
  readonly count: number;
  readonly x: number;
  readonly z: number;
  readonly groundReach: number;
}

export class GroundView {
  readonly mesh: Mesh;
  private readonly material: ShaderMaterial;
  /** First cone and count; x, z, radius; x, z, radius: flat, as WebGL takes them. */
  private readonly ranges = new Int32Array(NEAR_FIGURES * 2);
  private readonly bounds = new Float32Array(NEAR_FIGURES * 3);
  private readonly spots = new Float32Array(MOST_SPOTS * 3);
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

  /** The first figures are seen cone by cone, the others as soft spots. */
  setFigures(figures: readonly GroundFigure[]): void {
    const { uniforms } = this.material;
    const near = Math.min(figures.length, NEAR_FIGURES);
    const spots = Math.min(figures.length - near, MOST_SPOTS);
    for (let i = 0; i < near; i++) {
      const figure = figures[i];
      this.ranges[i * 2] = figure.first;
      this.ranges[i * 2 + 1] = figure.count;
      setCircle(this.bounds, i, figure, figure.groundReach);
    }
    for (let i = 0; i < spots; i++) {
      setCircle(this.spots, i, figures[near + i], SPOT_RADIUS);
    }
    uniforms.figureCount.value = near;
    uniforms.spotCount.value = spots;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.material.dispose();
  }
}

function setCircle(circles: Float32Array, i: number, figure: GroundFigure, radius: number): void {
  circles[i * 3] = figure.x;
  circles[i * 3 + 1] = figure.z;
  circles[i * 3 + 2] = radius;
}
