/** The hovered and the selected pair in; frames around their row and column and a ring around their cell out. */
import { topPx, type MatrixGeometry } from './matrix-geometry';

const svgNamespace = 'http://www.w3.org/2000/svg';

export interface MarkedCell {
  readonly row: number;
  readonly column: number;
}

export class MatrixMarks {
  readonly element = document.createElementNS(svgNamespace, 'svg');
  private readonly frames = ['row', 'column'].map(() => this.rect('matrix-frame'));
  private readonly rings = ['hovered', 'selected'].map((of) => [
    this.rect(`matrix-halo ${of}`),
    this.rect(`matrix-ring ${of}`),
  ]);

  constructor() {
    this.element.setAttribute('class', 'matrix-marks');
    this.element.setAttribute('aria-hidden', 'true');
  }

  /** Frames are drawn for the hovered cell, or else for the selected one. */
  show(geometry: MatrixGeometry, hovered: MarkedCell | null, selected: MarkedCell | null): void {
    const { style } = this.element;
    style.left = `${geometry.left}px`;
    style.top = `${topPx}px`;
    this.element.setAttribute('width', String(geometry.side));
    this.element.setAttribute('height', String(geometry.side));
    const framed = hovered ?? selected;
    this.showFrames(geometry, framed);
    [hovered, selected].forEach((cell, k) => this.showRing(geometry, this.rings[k], cell));
  }

  private showFrames({ axis, zoom, side }: MatrixGeometry, cell: MarkedCell | null): void {
    for (const frame of this.frames) frame.toggleAttribute('hidden', cell === null);
    if (!cell) return;
    const [row, column] = this.frames;
    const [x, y] = [axis.start(cell.column) - zoom.x, axis.start(cell.row) - zoom.y];
    setBox(row, -0.5, y - 0.5, side + 1, axis.cell + 1);
    setBox(column, x - 0.5, -0.5, axis.cell + 1, side + 1);
  }

  private showRing(
    { axis, zoom }: MatrixGeometry,
    [halo, ring]: readonly SVGRectElement[],
    cell: MarkedCell | null,
  ): void {
    for (const rect of [halo, ring]) rect.toggleAttribute('hidden', cell === null);
    if (!cell) return;
    const [x, y] = [axis.start(cell.column) - zoom.x, axis.start(cell.row) - zoom.y];
    setBox(halo, x - 1.5, y - 1.5, axis.cell + 3, axis.cell + 3);
    setBox(ring, x - 3, y - 3, axis.cell + 6, axis.cell + 6);
  }

  private rect(className: string): SVGRectElement {
    const rect = document.createElementNS(svgNamespace, 'rect');
    rect.setAttribute('class', className);
    this.element.append(rect);
    return rect;
  }
}

function setBox(rect: SVGRectElement, x: number, y: number, width: number, height: number): void {
  const values = { x, y, width, height };
  for (const [name, value] of Object.entries(values)) rect.setAttribute(name, String(value));
}
