import { describe, expect, it } from 'vitest';
import { coneGeometry, detailFor, TRIANGLE_BUDGET, trianglesOf } from './cone-geometry';

describe('coneGeometry', () => {
  it('has the triangles it promises', () => {
    for (const cones of [1, 22, 30, 60, 100, 200]) {
      const triangles = (coneGeometry(cones).index?.count ?? 0) / 3;
      expect(triangles).toBe(trianglesOf(detailFor(cones)));
      expect(triangles * cones).toBeLessThanOrEqual(TRIANGLE_BUDGET);
    }
  });

  it('is closed: every edge between two triangles of area belongs to both', () => {
    const geometry = coneGeometry(22);
    const position = geometry.getAttribute('position');
    const end = geometry.getAttribute('end');
    // The rings at the tips have no width: their vertices are one.
    const name = (i: number): string => {
      const fraction = position.getZ(i);
      const tip = (end.getX(i) === 0 && fraction === 0) || (end.getX(i) === 1 && fraction === 1);
      return tip ? `tip ${end.getX(i)}` : String(i);
    };
    const edges = new Map<string, number>();
    const index = Array.from(geometry.index?.array ?? []);
    for (let i = 0; i < index.length; i += 3) {
      for (let k = 0; k < 3; k++) {
        const edge = `${name(index[i + k])}>${name(index[i + ((k + 1) % 3)])}`;
        edges.set(edge, (edges.get(edge) ?? 0) + 1);
      }
    }
    for (const [edge, count] of edges) {
      expect(count, edge).toBe(1);
      expect(edges.has(edge.split('>').reverse().join('>')), edge).toBe(true);
    }
  });
});
