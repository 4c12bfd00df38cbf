/** A scene and its geometry in; tree and names as SVG text out. */
import { labelColour, type ComparePalette } from './compare-palette';
import { topPx, type MatrixGeometry } from './matrix-geometry';
import { markTag } from './mark-tag';
import type { Scene } from './scene';
import { tag, textTag } from './svg-text';
import { treeViewOf } from './tree-canvas';
import { visitBranches } from './tree-layout';

export function treeTags(scene: Scene, geometry: MatrixGeometry, palette: ComparePalette): string {
  if (geometry.treeWidth === 0) return '';
  const paths = new Map<string, string>();
  const at = (value: number): string => value.toFixed(2);
  visitBranches(treeViewOf(scene, geometry), ({ child, parentX, parentY, x, y }) => {
    const colour = labelColour(palette, scene.nodes.label[child]);
    const path = `M${at(parentX)} ${at(parentY + topPx)}V${at(y + topPx)}H${at(x)}`;
    paths.set(colour, (paths.get(colour) ?? '') + path);
  });
  const root = scene.nodes.height.length - 1;
  const rootX = geometry.heights.x(scene.nodes.height[root]);
  const rootPath = `M${at(rootX)} ${at(geometry.middles[root] + topPx)}h-8`;
  paths.set(palette.text3, (paths.get(palette.text3) ?? '') + rootPath);
  return [...paths]
    .map(([stroke, d]) => tag('path', { d, stroke, fill: 'none', 'stroke-width': 1.25 }))
    .join('');
}

export function cutTag({ cut }: Scene, geometry: MatrixGeometry, palette: ComparePalette): string {
  if (!cut || geometry.treeWidth === 0) return '';
  const x = geometry.heights.x(cut.height);
  const dashes = { 'stroke-width': 1.5, 'stroke-dasharray': '4 3' };
  const bottom = topPx + geometry.side + 4;
  return tag('line', { x1: x, x2: x, y1: topPx - 4, y2: bottom, stroke: palette.kp, ...dashes });
}

export function nameTags(scene: Scene, geometry: MatrixGeometry, palette: ComparePalette): string {
  const { axis, namesLeft, named } = geometry;
  if (!named) return '';
  const tags = Array.from(scene.order, (item, position) => {
    const y = topPx + axis.middle(position);
    const text = { x: namesLeft + 15, y: y + 3.8, 'font-size': 10.5, fill: palette.text2 };
    const mark = markTag(palette, scene.labelOfItem[item], namesLeft + 7, y, 3.3);
    return mark + textTag(scene.names[item], text);
  });
  return tags.join('');
}
