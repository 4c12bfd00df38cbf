/** In: how many cones a figure has. Out: the mesh of one cone, placed by the figure's vertex shader. */
import { BufferAttribute, InstancedBufferGeometry } from 'three';

/** Triangles a figure may have. */
export const TRIANGLE_BUDGET = 3000;

/** Corners of the outline, and rings from the point that faces the eye out to it. */
export interface ConeDetail {
  readonly corners: number;
  readonly rings: number;
}

const DETAILS: readonly ConeDetail[] = [
  { corners: 24, rings: 4 },
  { corners: 19, rings: 4 },
  { corners: 18, rings: 3 },
  { corners: 15, rings: 2 },
  { corners: 10, rings: 2 },
  { corners: 10, rings: 1 },
  { corners: 6, rings: 1 },
  { corners: 4, rings: 1 },
];

/** A fan in the middle and bands of two triangles a corner around it. */
export function trianglesOf(detail: ConeDetail): number {
  return detail.corners * (2 * detail.rings - 1);
}

/** The finest cone with which a figure of so many cones stays in the budget, else the coarsest. */
export function detailFor(cones: number): ConeDetail {
  const fitting = DETAILS.find((detail) => trianglesOf(detail) * cones <= TRIANGLE_BUDGET);
  return fitting ?? DETAILS[DETAILS.length - 1];
}

/** Vertices (cos, sin, ring 0 … 1) of the half of a cone that faces the eye. */
export function coneGeometry(cones: number): InstancedBufferGeometry {
  const { corners, rings } = detailFor(cones);
  const positions: number[] = [];
  for (let ring = 0; ring <= rings; ring++) {
    for (let corner = 0; corner < corners; corner++) {
      // Half a step off the axis, so that no corner lies between the two ends of the cone.
      const angle = (2 * Math.PI * (corner + 0.5)) / corners;
      positions.push(Math.cos(angle), Math.sin(angle), ring / rings);
    }
  }
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(positions), 3));
  geometry.setIndex(coneIndex(corners, rings));
  geometry.instanceCount = cones;
  return geometry;
}

/** The vertices of ring 0 are one point: its band is a fan. */
function coneIndex(corners: number, rings: number): number[] {
  const index: number[] = [];
  for (let ring = 0; ring < rings; ring++) {
    for (let corner = 0; corner < corners; corner++) {
      const a = ring * corners + corner;
      const b = ring * corners + ((corner + 1) % corners);
      index.push(a, a + corners, b + corners);
      if (ring > 0) index.push(a, b + corners, b);
    }
  }
  return index;
}
