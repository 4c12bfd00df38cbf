/** A scene and its distances in; matrix with tree, names and legend as SVG text out. */
import type { Words } from '../app/i18n/catalogue';
import { ColourScale } from './colour-scale';
import { labelColour, type ComparePalette } from './compare-palette';
import { legendDigits } from './legend';
import { positionsUnder } from './matrix-axis';
import { groupRuns, digitPx, numberBaselinePx, tickPx } from './matrix-canvas';
import { matrixGeometry, noZoom, topPx, type MatrixGeometry } from './matrix-geometry';
import { colourPicture, paintMatrix, type PlacedPicture } from './matrix-pixels';
import { pixelOf, rgbOf } from './colour-scale';
import { pictureLegend } from './picture-legend';
import type { Scene } from './scene';
import { svgSheet, tag, textTag } from './svg-text';
import { cutTag, nameTags, treeTags } from './tree-picture';

/** Up to so many clips every cell is a rectangle; beyond, the cells are one picture. */
const mostRects = 150;
const namedCellPx = 13;
const manySidePx = 1600;
/** The scale of colours, over the legend. */
const scaleRowPx = 40;
const sidePx = 20;

export interface PictureParts {
  readonly scene: Scene;
  readonly palette: ComparePalette;
  readonly words: Words;
  readonly longestNamePx: number;
}

/** Room for named cells while there are not too many clips. */
export function pictureGeometry({ scene, longestNamePx }: PictureParts): MatrixGeometry {
  const gaps = 4 * (scene.cut?.clusters ?? scene.labels.length);
  const side = scene.count <= mostRects ? scene.count * namedCellPx + gaps : manySidePx;
  const size = { width: side + 146 + longestNamePx + 60, height: side + topPx + 8 };
  return matrixGeometry(scene, size, noZoom, longestNamePx);
}

export function svgOfMatrix(parts: PictureParts, placed: PlacedPicture): string {
  const { scene, palette, words } = parts;
  const geometry = pictureGeometry(parts);
  const scale = new ColourScale(palette.distances, scene.comparison.legendMaximum);
  const width = geometry.left + geometry.side + 16;
  const legend = pictureLegend(scene, width - 2 * sidePx);
  const bottom = topPx + geometry.side;
  const height = bottom + scaleRowPx + legend.heightPx + 8;
  const cells =
    scene.count <= mostRects
      ? cellRects(scene, geometry, placed, scale)
      : cellImage(geometry, placed, scale, palette);
  const content =
    treeTags(scene, geometry, palette) +
    cutTag(scene, geometry, palette) +
    nameTags(scene, geometry, palette) +
    tag('g', { transform: `translate(${geometry.left} ${topPx})` }, cells) +
    heading(scene, geometry, palette) +
    scaleTags(parts, scale, bottom + 20) +
    legend.tags(palette, sidePx, bottom + scaleRowPx);
  const title = words.t('matrix.label');
  return svgSheet({ width, height, ground: palette.panel, title }, content);
}

function cellRects(
  { count }: Scene,
  { axis }: MatrixGeometry,
  { picture }: PlacedPicture,
  scale: ColourScale,
): string {
  const rects: string[] = [];
  for (let row = 0; row < count; row += 1)
    for (let column = 0; column < count; column += 1) {
      if (row === column) continue;
      const fill = scale.css(picture.values[row * picture.columns + column]);
      const [x, y] = [axis.start(column), axis.start(row)];
      rects.push(tag('rect', { x, y, width: axis.cell, height: axis.cell, fill }));
    }
  return tag('g', { 'shape-rendering': 'crispEdges' }, rects.join(''));
}

function cellImage(
  { axis, side }: MatrixGeometry,
  placed: PlacedPicture,
  scale: ColourScale,
  palette: ComparePalette,
): string {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = Math.round(side);
  const context = canvas.getContext('2d');
  if (!context) return '';
  const image = new ImageData(canvas.width, canvas.width);
  const positions = positionsUnder(axis, 0, canvas.width, 1);
  paintMatrix(new Uint32Array(image.data.buffer), {
    placed,
    colours: colourPicture(placed.picture, scale),
    rows: positions,
    columns: positions,
    background: pixelOf(rgbOf(palette.panel)),
  });
  context.putImageData(image, 0, 0);
  return tag('image', { width: side, height: side, href: canvas.toDataURL('image/png') });
}

/** Ticks in the colours of the labels, and the numbers of the clusters. */
function heading(scene: Scene, { axis, left }: MatrixGeometry, palette: ComparePalette): string {
  const ticks = Array.from(scene.order, (item, position) => {
    const label = scene.labelOfItem[item];
    if (label < 0) return '';
    const box = { x: left + axis.start(position), y: topPx - tickPx.top, height: tickPx.height };
    const width = Math.max(0.5, axis.cell - (axis.cell > 6 ? 1 : 0));
    return tag('rect', { ...box, width, fill: labelColour(palette, label) });
  });
  const look = { y: numberBaselinePx, 'font-size': 10.5, fill: palette.text3 };
  const runs = scene.kind === 'tree' && scene.cut ? groupRuns(scene.groups) : [];
  let right = -Infinity;
  const numbers = runs.map(({ group, first, end }) => {
    const [from, to] = [axis.start(first), axis.start(end - 1) + axis.cell];
    const [middle, half] = [(from + to) / 2, (String(group + 1).length * digitPx) / 2];
    if (middle - half < right + digitPx / 2) return '';
    right = middle + half;
    const place = { x: left + middle, 'text-anchor': 'middle' };
    return textTag(String(group + 1), { ...place, ...look });
  });
  return ticks.join('') + numbers.join('');
}

/** The scale of colours with its numbers. */
function scaleTags({ scene, palette, words }: PictureParts, scale: ColourScale, y: number): string {
  const { t, format } = words;
  const end = scene.comparison.legendMaximum;
  const [x, width] = [60, 150];
  const steps = Array.from({ length: width }, (_, k) =>
    tag('rect', { x: x + k, y, width: 1.2, height: 8, fill: scale.css((end * k) / width) }),
  );
  const look = { y: y + 8, 'font-size': 12, fill: palette.text2 };
  const number = format.decimal(end, legendDigits(end));
  const range = scene.comparison.maximum > end ? 'legend.range.clipped' : 'legend.range';
  return (
    textTag(t('legend.alike'), { x: x - 8, 'text-anchor': 'end', ...look }) +
    steps.join('') +
    textTag(`${t('legend.different')} · ${t(range, number)}`, { x: x + width + 8, ...look })
  );
}
