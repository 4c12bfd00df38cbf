/** In: a flat figure, a place. Out: the figure as SVG elements. */
import './figure.css';
import { hullPath } from './cone-outline';
import { FLAT_STRIDE, type FlatFigure, type FlatLimb } from './flat-figure';

const SVG_NAMESPACE = 'http://www.w3.org/2000/svg';
/** Width of the stroke in the ground's colour behind each limb, in pixels. */
const HALO_WIDTH = 1.5;

/** Where a figure stands: its pelvis over `x`, its ground at `groundY`. */
export interface FigurePlace {
  /** Pixels for one body height. */
  readonly scale: number;
  readonly x: number;
  readonly groundY: number;
}

/** Appends the figure to `parent` as one group; figure.css gives it its colours. */
export function drawFlatFigure(
  parent: Element,
  figure: FlatFigure,
  place: FigurePlace,
): SVGGElement {
  const group = parent.ownerDocument.createElementNS(SVG_NAMESPACE, 'g');
  group.setAttribute('class', 'figure');
  for (const limb of figure.limbs) {
    const path = parent.ownerDocument.createElementNS(SVG_NAMESPACE, 'path');
    path.setAttribute('class', `limb limb-${limb.side}${limb.far ? ' limb-far' : ''}`);
    path.setAttribute('d', limbPath(limb, place));
    path.setAttribute('stroke-width', String(HALO_WIDTH));
    group.append(path);
  }
  parent.append(group);
  return group;
}

/** SVG path data of one limb: the union (non-zero) of its cones. */
export function limbPath({ cones }: FlatLimb, { scale, x, groundY }: FigurePlace): string {
  let data = '';
  for (let i = 0; i < cones.length; i += FLAT_STRIDE) {
    data += hullPath(
      x + scale * cones[i],
      groundY - scale * cones[i + 1],
      scale * cones[i + 2],
      x + scale * cones[i + 3],
      groundY - scale * cones[i + 4],
      scale * cones[i + 5],
    );
  }
  return data;
}

/** Scale and place that fit a figure into a box, its outline centred; `maxScale` in pixels. */
export function fitFigure(
  figure: FlatFigure,
  width: number,
  height: number,
  padding: number,
  maxScale = Infinity,
): FigurePlace {
  const scale = Math.min(
    (width - 2 * padding) / Math.max(figure.maxX - figure.minX, 1e-6),
    (height - 2 * padding) / Math.max(figure.maxY - figure.minY, 1e-6),
    maxScale,
  );
  return {
    scale,
    x: width / 2 - (scale * (figure.minX + figure.maxX)) / 2,
    groundY: height / 2 + (scale * (figure.minY + figure.maxY)) / 2,
  };
}
