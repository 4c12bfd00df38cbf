/** A scene, the size of the pane and the zoom in; where tree, names and matrix stand in it out. */
import { MatrixAxis, fitAxis, leastNamedCellPx, mostCellPx, type Fit } from './matrix-axis';
import type { Scene } from './scene';
import { HeightScale, nodeMiddles } from './tree-layout';

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** What the person zoomed to; a cell of null: everything in sight. */
export interface Zoom {
  readonly cell: number | null;
  /** Pixels of the matrix left of and above the part in sight. */
  readonly x: number;
  readonly y: number;
}

export const noZoom: Zoom = { cell: null, x: 0, y: 0 };

/** Room above the matrix for the cut's handle, the numbers of the clusters and the ticks. */
export const topPx = 28;
const edgePx = 16;
const rightPx = 12;
const bottomPx = 8;
const usual = { tree: 146, names: 58 };
/** In a narrow pane. */
const small = { tree: 84, names: 54 };
const narrowPx = 520;
const mostNamesPx = 168;
/** So much they take from the matrix if they need it. */
const needyNamesPx = 104;
const leastMatrixPx = 60;

export interface MatrixGeometry extends Size {
  readonly axis: MatrixAxis;
  readonly fit: Fit;
  readonly middles: Float64Array;
  readonly heights: HeightScale;
  readonly treeLeft: number;
  readonly treeWidth: number;
  readonly namesLeft: number;
  readonly namesWidth: number;
  /** Left edge of the matrix; its top edge is `topPx`. */
  readonly left: number;
  /** Width and height of the part in sight. */
  readonly side: number;
  readonly zoom: Zoom;
  /** Names stand beside their rows; else they show in a lens. */
  readonly named: boolean;
}

const clamp = (value: number, least: number, most: number): number =>
  Math.max(least, Math.min(most, value));

interface Columns {
  readonly treeWidth: number;
  readonly namesLeft: number;
  /** Of the matrix, the same in every order. */
  readonly left: number;
}

/** Names take what the matrix leaves over, as far as they need it; without a tree its room too. */
function columnsOf({ kind }: Scene, size: Size, longestNamePx: number): Columns {
  const widths = size.width < narrowPx ? small : usual;
  const matrix = size.height - topPx - bottomPx;
  const spare = size.width - edgePx - widths.tree - widths.names - rightPx - matrix;
  const wanted = clamp(longestNamePx, widths.names, mostNamesPx);
  const least = size.width < narrowPx ? widths.names : needyNamesPx;
  const names = Math.min(wanted, Math.max(least, widths.names + spare));
  const left = edgePx + widths.tree + names;
  if (kind === 'tree') return { treeWidth: widths.tree, namesLeft: left - names, left };
  return { treeWidth: 0, namesLeft: Math.max(edgePx, left - longestNamePx), left };
}

/** The same zoom within what there is to see. */
function held(zoom: Zoom, fit: Fit, axis: MatrixAxis, side: number): Zoom {
  const most = Math.max(0, axis.length - side);
  const cell = zoom.cell !== null && zoom.cell > fit.cell ? axis.cell : null;
  return { cell, x: clamp(zoom.x, 0, most), y: clamp(zoom.y, 0, most) };
}

const treeEndPx = 6;

export function matrixGeometry(
  scene: Scene,
  size: Size,
  wanted: Zoom,
  longestNamePx: number,
): MatrixGeometry {
  const { treeWidth, namesLeft, left } = columnsOf(scene, size, longestNamePx);
  const room = Math.max(
    leastMatrixPx,
    Math.min(size.width - left - rightPx, size.height - topPx - bottomPx),
  );
  const fit = fitAxis(scene.groups, room);
  const cell = Math.min(mostCellPx, Math.max(fit.cell, wanted.cell ?? 0));
  const axis = new MatrixAxis(scene.groups, { cell, gap: cell > fit.cell ? 4 : fit.gap });
  const { tree } = scene.comparison;
  const highest = (tree.heights.at(-1) ?? 0) * 1.02;
  return {
    ...size,
    axis,
    fit,
    middles: nodeMiddles(tree, scene.nodes, axis),
    heights: new HeightScale(edgePx + 8, namesLeft - treeEndPx, highest),
    treeLeft: edgePx,
    treeWidth,
    namesLeft,
    namesWidth: left - namesLeft,
    left,
    side: Math.min(room, axis.length),
    zoom: held(wanted, fit, axis, room),
    named: axis.cell >= leastNamedCellPx,
  };
}

/** Cells `factor` times as large, the matrix's pixel under (x, y) of the part in sight held. */
export function zoomedBy(geometry: MatrixGeometry, factor: number, x: number, y: number): Zoom {
  const { axis, fit, zoom } = geometry;
  const cell = clamp(axis.cell * factor, fit.cell, mostCellPx);
  const ratio = cell / axis.cell;
  return {
    cell: cell > fit.cell ? cell : null,
    x: (zoom.x + x) * ratio - x,
    y: (zoom.y + y) * ratio - y,
  };
}

/** The zoom moved as little as brings a cell into sight. */
export function zoomShowing(geometry: MatrixGeometry, row: number, column: number): Zoom {
  const { axis, side, zoom } = geometry;
  const into = (scroll: number, position: number): number =>
    clamp(scroll, axis.start(position) + axis.cell - side, axis.start(position));
  return { cell: zoom.cell, x: into(zoom.x, column), y: into(zoom.y, row) };
}
