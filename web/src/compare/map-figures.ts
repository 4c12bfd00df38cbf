/** Points of a map and the room beside them in; a figure for each of the largest clusters out. */
import { html, type TemplateResult } from 'lit-html';
import { drawn, styled } from '../common/directives';
import { drawFlatFigure, fitFigure } from '../figure/draw-flat-figure';
import type { FlatFigure } from '../figure/flat-figure';
import type { Point } from './hull';
import { clusterAnchors, discRadius } from './map-canvas';
import { placeFigures, type Box } from './map-layout';
import type { Scene } from './scene';

const figurePx = { width: 44, height: 48, padding: 2 };
/** Clusters beyond the largest of so many have no figure. */
const mostFigures = 10;

export interface PlacedFigure {
  readonly item: number;
  readonly at: Point;
}

/** Where there is no room beside its cluster, none. */
export function figuresBeside(
  { scene, points }: { readonly scene: Scene; readonly points: readonly Point[] },
  room: Box,
  taken: readonly Box[],
): readonly PlacedFigure[] {
  const anchors = clusterAnchors(scene, points, mostFigures);
  const radius = discRadius(scene.count) + 1;
  const places = placeFigures(anchors, { room, ...figurePx, points, radius, taken });
  return anchors.flatMap(({ item }, k) => {
    const at = places[k];
    return at ? [{ item, at }] : [];
  });
}

export function mapFigure(figure: FlatFigure, [x, y]: Point): TemplateResult {
  const { width, height, padding } = figurePx;
  const draw = (svg: Element): void =>
    void drawFlatFigure(svg, figure, fitFigure(figure, width, height, padding));
  return html`<svg
    class="map-figure"
    viewBox="0 0 ${width} ${height}"
    ${styled({ left: `${x - width / 2}px`, top: `${y - height / 2}px` })}
    ${drawn(figure, draw)}
  ></svg>`;
}
