/** Where a joint came from, as a shape: disc by name, square by shape, triangle for a stand-in, diamond by hand. */
import type { BodyJoint } from '../engine/types';

export type JointSource = BodyJoint['source'];

export const jointSources: readonly JointSource[] = ['name', 'shape', 'fallback', 'user'];

const squareShare = 0.88;
const triangleShare = 1.18;
const diamondShare = 1.25;

/** SVG path data of the glyph of a source around a place. */
export function glyphPath(source: JointSource, x: number, y: number, radius: number): string {
  if (source === 'name')
    return `M${x - radius} ${y}a${radius} ${radius} 0 1 0 ${2 * radius} 0a${radius} ${radius} 0 1 0 ${-2 * radius} 0Z`;
  if (source === 'shape') {
    const half = radius * squareShare;
    return `M${x - half} ${y - half}h${2 * half}v${2 * half}h${-2 * half}Z`;
  }
  const r = radius * (source === 'fallback' ? triangleShare : diamondShare);
  if (source === 'user') return `M${x} ${y - r}L${x + r} ${y}L${x} ${y + r}L${x - r} ${y}Z`;
  return `M${x} ${y - r}L${x + r} ${y + r * 0.8}H${x - r}Z`;
}
