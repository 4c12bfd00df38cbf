/** A label and a place in; its shape in its colour as SVG text out. */
import { labelStyle } from '../app/labels';
import { labelColour, type ComparePalette } from './compare-palette';
import { shapePath, type LabelShape } from '../common/label-shape';
import { tag, type Attributes } from './svg-text';

export interface MarkLook {
  readonly shape: LabelShape;
  readonly colour: string;
  readonly open: boolean;
}

/** −1: a clip without a label. */
export function markLook(palette: ComparePalette, label: number): MarkLook {
  const { shape, open } = label < 0 ? { shape: 'circle' as const, open: false } : labelStyle(label);
  return { shape, open, colour: labelColour(palette, label) };
}

export function markTag(
  palette: ComparePalette,
  label: number,
  x: number,
  y: number,
  radius: number,
  halo = 0,
): string {
  const { shape, colour, open } = markLook(palette, label);
  const d = shapePath(shape, x, y, radius);
  const around = halo
    ? tag('path', { d, fill: palette.panel, stroke: palette.panel, 'stroke-width': halo })
    : '';
  const look: Attributes = open
    ? { fill: palette.panel, stroke: colour, 'stroke-width': 1.5 }
    : { fill: colour };
  return around + tag('path', { d, ...look });
}
