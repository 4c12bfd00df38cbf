/** In: how many cones a figure has. Out: the mesh of one cone, placed by the figure's vertex shader. */
import { BufferAttribute, InstancedBufferGeometry } from 'three';

/** Triangles a figure may have. */
export const TRIANGLE_BUDGET = 3000;

/** Sides around the cone and rings over each of its two ends. */
export interface ConeDetail {
  readonly sides: number;
  readonly rings: number;
}

const DETAILS: readonly ConeDetail[] = [
  { sides: 12, rings: 3 },
  { sides: 11, rings: 3 },
  { sides: 12, rings: 2 },
  { sides: 8, rings: 2 },
  { sides: 6, rings: 2 },
  { sides: 6, rings: 1 },
  { sides: 4, rings: 1 },
  { sides: 3, rings: 1 },
];

/** Two fans of `sides` triangles at the tips and 2 · rings − 1 bands of 2 · `sides` between them. */
export function trianglesOf(detail: ConeDetail): number {
  return 4 * detail.sides * detail.rings;
}

/** The finest cone with which a figure of so many cones stays in the budget, else the coarsest. */
export function detailFor(cones: number): ConeDetail {
  const fitting = DETAILS.find((detail) => trianglesOf(detail) * cones <= TRIANGLE_BUDGET);
  return fitting ?? DETAILS[DETAILS.length - 1];
}

/** Vertices from tip to tip: (cos, sin, fraction of the end's arc) and which end. */
export function coneGeometry(cones: number): InstancedBufferGeometry {
  const { sides, rings } = detailFor(cones);
  const positions: number[] = [];
  const ends: number[] = [];
  for (let row = 0; row < 2 * rings + 2; row++) {
    const end = row <= rings ? 0 : 1;
    for (let side = 0; side < sides; side++) {
      const angle = (2 * Math.PI * side) / sides;
      positions.push(Math.cos(angle), Math.sin(angle), (row - end * (rings + 1)) / rings);
      ends.push(end);
    }
  }
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(positions), 3));
  geometry.setAttribute('end', new BufferAttribute(Float32Array.from(ends), 1));
  geometry.setIndex(coneIndex(sides, 2 * rings + 1));
  geometry.instanceCount = cones;
  return geometry;
}

/** The first and the last band touch a tip, where one of the two triangles has no area. */
function coneIndex(sides: number, bands: number): number[] {
  const index: number[] = [];
  for (let band = 0; band < bands; band++) {
    for (let side = 0; side < sides; side++) {
      const a = band * sides + side;
      const b = band * sides + ((side + 1) % sides);
      if (band > 0) index.push(a, b, a + sides);
      if (band < bands - 1) index.push(b, b + sides, a + sides);
    }
  }
  return index;
}
