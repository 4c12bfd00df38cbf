/** A scene and its figures in; the map as SVG text out. */
import type { FlatFigure, FlatLimb } from '../figure/flat-figure';
import { fitFigure, limbPath } from '../figure/draw-flat-figure';
import { rgbOf } from './colour-scale';
import type { ComparePalette } from './compare-palette';
import { convexHull, type Point } from './hull';
import { clusterAnchors, discRadius, hullColour, hullPathOf, membersOf } from './map-canvas';
import { fitMap, onScreen, placeFigures, type Box } from './map-layout';
import { markTag } from './mark-tag';
import type { PictureParts } from './matrix-picture';
import { pictureLegend } from './picture-legend';
import type { Scene } from './scene';
import { svgSheet, tag, textTag } from './svg-text';

const widthPx = 880;
const sidePx = 20;
/** Of the map, over its legend. */
const margins = { left: 90, top: 110, right: 90, bottom: 102 };
const figureMargins = { left: 4, top: 40, right: 4, bottom: 8 };
const leastHeightPx = 390;
const figurePx = { width: 66, height: 72 };
const mostFigures = 10;

const inside = (height: number, by: Box): Box => ({
  left: by.left,
  top: by.top,
  right: widthPx - by.right,
  bottom: height - by.bottom,
});

/** As high as the map is at the full width, within reason. */
function mapHeight(map: Float64Array): number {
  const square = fitMap(map, { left: 0, top: 0, right: 1, bottom: 1e9 });
  const ys = map.filter((_, k) => k % 2 === 1);
  const high =
    ys.length > 0 ? ys.reduce((a, b) => Math.max(a, b)) - ys.reduce((a, b) => Math.min(a, b)) : 0;
  const wanted = (widthPx - margins.left - margins.right) * square.scale * high;
  return Math.max(leastHeightPx, Math.min(widthPx, wanted + margins.top + margins.bottom));
}

export function svgOfMap(
  parts: PictureParts,
  figureOf: (item: number) => FlatFigure | null,
): string {
  const { scene, palette, words } = parts;
  const { map, spread } = scene.comparison;
  const height = mapHeight(map);
  const legend = pictureLegend(scene, widthPx - 2 * sidePx);
  const transform = fitMap(map, inside(height, margins));
  const points = Array.from({ length: scene.count }, (_, item) =>
    onScreen(transform, [map[2 * item], map[2 * item + 1]]),
  );
  const discs = points.map(([x, y], item) =>
    markTag(palette, scene.labelOfItem[item], x, y, discRadius(scene.count), 2.4),
  );
  const title = `${words.t('map.title')}, ${words.t('map.spread', Math.round(100 * spread))}`;
  const heading = { x: 24, y: 28, 'font-size': 13, fill: palette.text2 };
  const content =
    hullTags(scene, palette, points) +
    discs.join('') +
    figureTags(scene, palette, points, height, figureOf) +
    textTag(title, heading) +
    legend.tags(palette, sidePx, height);
  const sheet = { width: widthPx, height: height + legend.heightPx + 12 };
  return svgSheet({ ...sheet, ground: palette.panel, title }, content);
}

function hullTags(scene: Scene, palette: ComparePalette, points: readonly Point[]): string {
  const colour = hullColour(palette);
  const round = { 'stroke-linejoin': 'round', 'stroke-linecap': 'round', 'stroke-width': 24 };
  const paths = membersOf(scene).map((members) => {
    if (members.length === 0) return '';
    const d = hullPathOf(convexHull(members.map((item) => points[item])));
    return tag('path', { d, fill: colour, stroke: colour, ...round });
  });
  return paths.join('');
}

function figureTags(
  scene: Scene,
  palette: ComparePalette,
  points: readonly Point[],
  height: number,
  figureOf: (item: number) => FlatFigure | null,
): string {
  const anchors = clusterAnchors(scene, points, mostFigures);
  const radius = discRadius(scene.count) + 1;
  const figures = { room: inside(height, figureMargins), ...figurePx, points, radius, taken: [] };
  const places = placeFigures(anchors, figures);
  const tags = anchors.map(({ item }, k) => {
    const [figure, place] = [figureOf(item), places[k]];
    return figure && place ? figureTag(figure, place, palette) : '';
  });
  return tags.join('');
}

function figureTag(figure: FlatFigure, [x, y]: Point, palette: ComparePalette): string {
  const { width, height } = figurePx;
  const place = fitFigure(figure, width, height, 2);
  const limbs = figure.limbs.map((limb) =>
    tag('path', {
      d: limbPath(limb, place),
      fill: limbColour(limb, palette),
      stroke: palette.panel,
      'stroke-width': 1.5,
      'paint-order': 'stroke',
    }),
  );
  return tag('g', { transform: `translate(${x - width / 2} ${y - height / 2})` }, limbs.join(''));
}

const shadePart = 0.26;

/** Mixed by hand: few programs that read SVG know `color-mix`. */
function limbColour({ side, far }: FlatLimb, palette: ComparePalette): string {
  const colour = palette[side];
  if (!far || side === 'trunk') return colour;
  const [own, shade] = [rgbOf(colour), rgbOf(palette.shade)];
  const mixed = own.map((byte, k) => Math.round(byte * (1 - shadePart) + shade[k] * shadePart));
  return `rgb(${mixed.join(', ')})`;
}
