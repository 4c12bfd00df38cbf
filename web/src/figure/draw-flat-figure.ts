/** In: a flat figure, a place. Out: the figure as SVG elements or on a canvas. */
import './figure.css';
import type { Side } from './bone-cone';
import { hullPath, traceHull } from './cone-outline';
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

/** Colours for drawing on a canvas, as CSS colours. */
export interface FigureColours {
  readonly left: string;
  readonly right: string;
  readonly trunk: string;
  /** Mixed into the farther limb of a pair. */
  readonly shade: string;
  /** The ground behind the figure. */
  readonly ground: string;
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
export function limbPath(limb: FlatLimb, place: FigurePlace): string {
  let data = '';
  eachCone(limb, place, (...circles) => {
    data += hullPath(...circles);
  });
  return data;
}

/** Draws the figure on a canvas, in CSS pixels of its current transform. */
export function paintFlatFigure(
  context: CanvasRenderingContext2D,
  figure: FlatFigure,
  place: FigurePlace,
  colours: FigureColours,
): void {
  context.lineJoin = 'round';
  context.lineWidth = HALO_WIDTH;
  context.strokeStyle = colours.ground;
  for (const limb of figure.limbs) {
    context.beginPath();
    eachCone(limb, place, (...circles) => {
      traceHull(context, ...circles);
    });
    context.stroke();
    context.fillStyle = limbColour(colours, limb.side, limb.far);
    context.fill();
  }
}

/** The colours as a page's theme has them at `element`; `ground` is the colour behind the figure. */
export function figureColours(element: Element, ground: string): FigureColours {
  const style = getComputedStyle(element);
  const read = (name: string): string => style.getPropertyValue(name).trim();
  return {
    left: read('--left'),
    right: read('--right'),
    trunk: read('--trunk'),
    shade: read('--shade'),
    ground,
  };
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

function limbColour(colours: FigureColours, side: Side, far: boolean): string {
  return far ? `color-mix(in oklab, ${colours[side]} 74%, ${colours.shade})` : colours[side];
}

type ConeVisitor = (x1: number, y1: number, r1: number, x2: number, y2: number, r2: number) => void;

function eachCone(limb: FlatLimb, { scale, x, groundY }: FigurePlace, visit: ConeVisitor): void {
  const { cones } = limb;
  for (let i = 0; i < cones.length; i += FLAT_STRIDE) {
    visit(
      x + scale * cones[i],
      groundY - scale * cones[i + 1],
      scale * cones[i + 2],
      x + scale * cones[i + 3],
      groundY - scale * cones[i + 4],
      scale * cones[i + 5],
    );
  }
}
