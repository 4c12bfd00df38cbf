/**
 * Pointer and keys over the matrix in; the hovered and the chosen pair, zoom and pan out. For ears a grid
 * with headers, of which one cell exists.
 */
import { element } from '../common/element';
import { spokenPair } from './pair-tip';
import { RovingCell } from './roving-cell';
import { choosePair, hover, openPair, type Shared } from './shared';
import {
  topPx,
  zoomShowing,
  zoomedBy,
  noZoom,
  type MatrixGeometry,
  type Zoom,
} from './matrix-geometry';
import { mostCellPx } from './matrix-axis';
import type { Scene } from './scene';
import { pageScrolls, zoomFactor } from './wheel-zoom';

export interface GridState {
  readonly scene: Scene;
  readonly geometry: MatrixGeometry;
}

interface Cell {
  readonly row: number;
  readonly column: number;
}

const page = 10;
const zoomStep = 1.5;
const dragPx = 4;

export class MatrixGrid {
  readonly element = element('div', 'matrix-grid');
  private readonly columnHeader = element('span', 'spoken');
  private readonly rowHeader = element('span', 'spoken');
  private readonly row = element('div', 'matrix-row');
  private readonly roving: RovingCell;
  private state: GridState | null = null;
  private cell: Cell = { row: 0, column: 1 };
  /** Where the wheel has just been turned. */
  private pointer: { readonly clientX: number; readonly clientY: number } | null = null;
  private drag: { x: number; y: number; zoom: Zoom; moved: boolean } | null = null;

  constructor(
    private readonly shared: Shared,
    private readonly setZoom: (zoom: Zoom) => void,
  ) {
    const head = element('div', 'spoken');
    const { element: grid, row } = this;
    grid.setAttribute('role', 'grid');
    for (const line of [head, row]) line.setAttribute('role', 'row');
    head.setAttribute('aria-rowindex', '1');
    this.columnHeader.setAttribute('role', 'columnheader');
    this.rowHeader.setAttribute('role', 'rowheader');
    this.rowHeader.setAttribute('aria-colindex', '1');
    head.append(this.columnHeader);
    row.append(this.rowHeader);
    grid.append(head, row);
    this.roving = new RovingCell(row, () => {
      const cell = element('div', 'matrix-cell');
      cell.setAttribute('role', 'gridcell');
      cell.tabIndex = 0;
      return cell;
    });
    this.listen();
  }

  /** Where the focus is: the tip stands there. */
  get focused(): boolean {
    return this.roving.focused;
  }

  update(state: GridState): void {
    const moved = this.state?.scene !== state.scene;
    this.state = state;
    const { geometry, scene } = state;
    const { t } = this.shared.context.language.words.value;
    const { style } = this.element;
    style.left = `${geometry.left}px`;
    style.top = `${topPx}px`;
    style.width = style.height = `${geometry.side}px`;
    this.element.setAttribute('aria-label', t('matrix.label'));
    this.element.setAttribute('aria-rowcount', String(scene.count + 1));
    this.element.setAttribute('aria-colcount', String(scene.count + 1));
    this.element.classList.toggle('pans', geometry.axis.length > geometry.side + 0.5);
    if (moved && !this.roving.focused) this.startAtSelection(scene);
    this.cell = { row: this.within(this.cell.row), column: this.within(this.cell.column) };
    this.roving.stand(this.placeOf(this.cell));
    this.tell();
    this.hoverAgain();
  }

  private hoverAgain(): void {
    const cell = this.pointer && this.cellAt(this.pointer);
    if (this.pointer) hover(this.shared, cell && this.itemsOf(cell));
    this.pointer = null;
  }

  private startAtSelection({ positionOfItem }: Scene): void {
    const { a, b } = this.shared.selected.peek();
    if (a !== null && b !== null) this.cell = { row: positionOfItem[a], column: positionOfItem[b] };
  }

  private within(position: number): number {
    return Math.max(0, Math.min((this.state?.scene.count ?? 1) - 1, position));
  }

  private placeOf({ row, column }: Cell) {
    const { geometry } = this.state as GridState;
    const { axis, zoom } = geometry;
    const size = Math.max(axis.cell, 4);
    const [left, top] = [axis.start(column) - zoom.x, axis.start(row) - zoom.y];
    return { left, top, width: size, height: size };
  }

  private itemsOf({ row, column }: Cell): { a: number; b: number } {
    const { order } = (this.state as GridState).scene;
    return { a: order[row], b: order[column] };
  }

  /** Headers and the words of the one cell. */
  private tell(): void {
    const { scene } = this.state as GridState;
    const { row, column } = this.cell;
    const pair = this.itemsOf(this.cell);
    this.rowHeader.textContent = scene.names[pair.a];
    this.columnHeader.textContent = scene.names[pair.b];
    this.row.setAttribute('aria-rowindex', String(row + 2));
    this.columnHeader.setAttribute('aria-colindex', String(column + 2));
    this.roving.attribute('aria-colindex', String(column + 2));
    this.roving.say(this.words());
  }

  private words(): string {
    const { scene } = this.state as GridState;
    const pair = this.itemsOf(this.cell);
    const { clips } = scene.comparison;
    const known = this.shared.facts.value({ a: clips[pair.a], b: clips[pair.b] });
    return spokenPair(this.shared.context.language.words.value, scene, pair, known);
  }

  private move(row: number, column: number): void {
    if (!this.state) return;
    this.cell = { row: this.within(row), column: this.within(column) };
    this.setZoom(zoomShowing(this.state.geometry, this.cell.row, this.cell.column));
    this.roving.renew(this.words(), this.placeOf(this.cell));
    hover(this.shared, this.itemsOf(this.cell));
    this.tell();
  }

  private readonly onKey = (event: KeyboardEvent): void => {
    const { row, column } = this.cell;
    const last = (this.state?.scene.count ?? 1) - 1;
    const whole = event.ctrlKey || event.metaKey;
    const goals: Readonly<Record<string, readonly [number, number]>> = {
      ArrowLeft: [row, column - 1],
      ArrowRight: [row, column + 1],
      ArrowUp: [row - 1, column],
      ArrowDown: [row + 1, column],
      PageUp: [row - page, column],
      PageDown: [row + page, column],
      Home: [whole ? 0 : row, 0],
      End: [whole ? last : row, last],
    };
    const goal = goals[event.key];
    if (goal) this.move(...goal);
    else if (!this.act(event)) return;
    event.preventDefault();
  };

  /** Chooses, opens or zooms; false: the key means nothing here. */
  private act({ key, ctrlKey, metaKey }: KeyboardEvent): boolean {
    if (!this.state || ctrlKey || metaKey) return false;
    const { a, b } = this.itemsOf(this.cell);
    const { left, top, width } = this.placeOf(this.cell);
    const zoom = (factor: number): void => this.zoomAt(factor, left + width / 2, top + width / 2);
    if (key === ' ') choosePair(this.shared, a, b);
    else if (key === 'Enter') openPair(this.shared, a, b);
    else if (key === '+' || key === '=') zoom(zoomStep);
    else if (key === '-') zoom(1 / zoomStep);
    else if (key === '0') this.setZoom(noZoom);
    else return false;
    return true;
  }

  zoomAt(factor: number, x: number, y: number): void {
    if (this.state) this.setZoom(zoomedBy(this.state.geometry, factor, x, y));
  }

  private cellAt({ clientX, clientY }: { clientX: number; clientY: number }): Cell | null {
    if (!this.state) return null;
    const { axis, zoom } = this.state.geometry;
    const box = this.element.getBoundingClientRect();
    const row = axis.at(clientY - box.top + zoom.y);
    const column = axis.at(clientX - box.left + zoom.x);
    return row < 0 || column < 0 ? null : { row, column };
  }

  private listen(): void {
    const { element: grid } = this;
    grid.addEventListener('keydown', this.onKey);
    grid.addEventListener(
      'focusin',
      () => this.state && hover(this.shared, this.itemsOf(this.cell)),
    );
    grid.addEventListener('focusout', (event) => {
      if (!grid.contains(event.relatedTarget as Node | null)) hover(this.shared, null);
    });
    grid.addEventListener('pointerdown', (event) => {
      if (event.button !== 0 || !this.state) return;
      this.drag = {
        x: event.clientX,
        y: event.clientY,
        zoom: this.state.geometry.zoom,
        moved: false,
      };
      grid.setPointerCapture(event.pointerId);
    });
    grid.addEventListener('pointermove', this.onMove);
    grid.addEventListener('pointerleave', () => !this.focused && hover(this.shared, null));
    grid.addEventListener('click', (event) => this.onClick(event));
    grid.addEventListener('dblclick', (event) => {
      const cell = this.cellAt(event);
      if (cell) openPair(this.shared, this.itemsOf(cell).a, this.itemsOf(cell).b);
    });
    grid.addEventListener('wheel', this.onWheel, { passive: false });
  }

  private readonly onMove = (event: PointerEvent): void => {
    const { drag } = this;
    if (drag && this.element.hasPointerCapture(event.pointerId)) {
      const [dx, dy] = [event.clientX - drag.x, event.clientY - drag.y];
      drag.moved ||= Math.hypot(dx, dy) > dragPx;
      const { zoom } = drag;
      if (drag.moved) {
        hover(this.shared, null);
        this.setZoom({ cell: zoom.cell, x: zoom.x - dx, y: zoom.y - dy });
        return;
      }
    }
    const cell = this.cellAt(event);
    hover(this.shared, cell && this.itemsOf(cell));
  };

  private onClick(event: MouseEvent): void {
    const dragged = this.drag?.moved;
    this.drag = null;
    const cell = this.cellAt(event);
    if (dragged || !cell) return;
    this.cell = cell;
    this.tell();
    this.roving.stand(this.placeOf(cell));
    this.roving.focus();
    const { a, b } = this.itemsOf(cell);
    choosePair(this.shared, a, b);
  }

  private readonly onWheel = (event: WheelEvent): void => {
    const { geometry } = this.state ?? {};
    // Where everything is as large as it gets, the wheel scrolls the page.
    if (!geometry || geometry.fit.cell >= mostCellPx) return;
    const factor = zoomFactor(event, pageScrolls(this.element));
    if (factor === null) return;
    event.preventDefault();
    const box = this.element.getBoundingClientRect();
    this.zoomAt(factor, event.clientX - box.left, event.clientY - box.top);
    // Another cell may be under the pointer once the zoom has been drawn.
    this.pointer = { clientX: event.clientX, clientY: event.clientY };
  };
}
