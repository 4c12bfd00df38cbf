/** The scene and its geometry in; the branches of the tree on a canvas out, coloured while they are pure. */
import { prepareCanvas } from '../timeline/canvas';
import { labelColour, type ComparePalette } from './compare-palette';
import { topPx, type MatrixGeometry } from './matrix-geometry';
import type { Scene } from './scene';
import { visitBranches, type TreeView } from './tree-layout';

export interface TreeDrawing {
  readonly scene: Scene;
  readonly geometry: MatrixGeometry;
  readonly palette: ComparePalette;
}

const rootPx = 8;

export const treeViewOf = (scene: Scene, geometry: MatrixGeometry): TreeView => ({
  tree: scene.comparison.tree,
  nodes: scene.nodes,
  middles: geometry.middles,
  axis: geometry.axis,
  scale: geometry.heights,
  top: geometry.zoom.y,
  bottom: geometry.zoom.y + geometry.side,
});

/** Branches by colour, each a path: from the parent along its bar, then to the child. */
function pathsByColour(drawing: TreeDrawing): Map<string, Path2D> {
  const { scene, geometry, palette } = drawing;
  const paths = new Map<string, Path2D>();
  const shift = topPx - geometry.zoom.y;
  visitBranches(treeViewOf(scene, geometry), ({ child, parentX, parentY, x, y }) => {
    const colour = labelColour(palette, scene.nodes.label[child]);
    const path = paths.get(colour) ?? new Path2D();
    paths.set(colour, path);
    path.moveTo(parentX, parentY + shift);
    path.lineTo(parentX, y + shift);
    path.lineTo(x, y + shift);
  });
  return paths;
}

function rootPath({ scene, geometry }: TreeDrawing): Path2D {
  const root = scene.nodes.height.length - 1;
  const x = geometry.heights.x(scene.nodes.height[root]);
  const y = geometry.middles[root] + topPx - geometry.zoom.y;
  const path = new Path2D();
  path.moveTo(x, y);
  path.lineTo(x - rootPx, y);
  return path;
}

export function drawTree(canvas: HTMLCanvasElement, drawing: TreeDrawing): void {
  const { scene, geometry, palette } = drawing;
  const [width, height] = [geometry.namesLeft, geometry.side + topPx];
  canvas.hidden = geometry.treeWidth === 0 || scene.count === 0;
  const context = canvas.hidden ? null : prepareCanvas(canvas, width, height);
  if (!context) return;
  canvas.style.width = `${width}px`;
  canvas.style.height = `${height}px`;
  context.beginPath();
  context.rect(0, topPx, width, geometry.side);
  context.clip();
  context.lineWidth = geometry.axis.cell < 3 ? 1 : 1.25;
  for (const [colour, path] of pathsByColour(drawing)) {
    context.strokeStyle = colour;
    context.stroke(path);
  }
  context.strokeStyle = palette.text3;
  context.stroke(rootPath(drawing));
}
