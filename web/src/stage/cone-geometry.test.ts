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

  it('has no holes: every edge but the outline belongs to two triangles', () => {
    const geometry = coneGeometry(22);
    const position = geometry.getAttribute('position');
    const name = (i: number): string => (position.getZ(i) === 0 ? 'middle' : String(i));
    const outer = (i: number): boolean => position.getZ(i) === 1;
    const edges = new Map<string, boolean>();
    const index = Array.from(geometry.index?.array ?? []);
    for (let i = 0; i < index.length; i += 3) {
      for (let k = 0; k < 3; k++) {
        const [from, to] = [index[i + k], index[i + ((k + 1) % 3)]];
        const edge = `${name(from)}>${name(to)}`;
        expect(edges.has(edge), edge).toBe(false);
        edges.set(edge, outer(from) && outer(to));
      }
    }
    for (const [edge, outline] of edges) {
      expect(edges.has(edge.split('>').reverse().join('>')), edge).toBe(!outline);
    }
  });
});
