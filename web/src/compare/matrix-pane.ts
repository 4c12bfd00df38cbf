/** The shared scene in; tree, names and matrix on one axis out, with their zoom. */
import { computed, signal, untracked, type ReadonlySignal } from '@preact/signals-core';
import { follow } from '../common/mount';
import { watchPixelRatio } from '../timeline/canvas';
import { ColourScale } from './colour-scale';
import { CutSlider } from './cut-slider';
import { GroupNames } from './group-names';
import { longestNamePx } from './name-width';
import { MatrixCanvas } from './matrix-canvas';
import {
  matrixGeometry,
  noZoom,
  topPx,
  zoomShowing,
  type MatrixGeometry,
  type Zoom,
} from './matrix-geometry';
import { MatrixGrid, type GridState } from './matrix-grid';
import { MatrixMarks, type MarkedCell } from './matrix-marks';
import { colourPicture, type PlacedPicture } from './matrix-pixels';
import { NamesView } from './names-view';
import { PairTip } from './pair-tip';
import type { Scene } from './scene';
import type { ItemPair, Shared } from './shared';
import { drawTree } from './tree-canvas';

export class MatrixPane {
  readonly zoom = signal<Zoom>(noZoom);
  readonly geometry: ReadonlySignal<MatrixGeometry | null>;
  private readonly size = signal({ width: 0, height: 0 });
  private readonly ratio = signal(1);
  private readonly cells = new MatrixCanvas();
  private readonly tree = document.createElement('canvas');
  private readonly marks = new MatrixMarks();
  private readonly groups = new GroupNames();
  private readonly names: NamesView;
  private readonly grid: MatrixGrid;
  private readonly cut: CutSlider;
  private readonly tip: PairTip;
  private coloured: { placed: PlacedPicture; scale: ColourScale; colours: Uint32Array } | null =
    null;

  constructor(
    private readonly place: HTMLElement,
    private readonly shared: Shared,
  ) {
    const { compareActions } = shared.context;
    const setZoom = (zoom: Zoom): void => void (this.zoom.value = zoom);
    this.names = new NamesView(shared, (position) => this.reach(position));
    this.grid = new MatrixGrid(shared, setZoom);
    this.cut = new CutSlider((clusters) => compareActions.setCut(clusters));
    this.tip = new PairTip(shared);
    this.tree.className = 'tree-canvas';
    this.cells.canvas.className = 'matrix-canvas';
    for (const canvas of [this.tree, this.cells.canvas]) canvas.setAttribute('aria-hidden', 'true');
    place.append(this.tree, this.cells.canvas, this.groups.element);
    place.append(this.names.element, this.grid.element);
    place.append(this.marks.element, this.cut.element, this.names.lens, this.tip.element);
    new ResizeObserver(() => {
      this.size.value = { width: place.clientWidth, height: place.clientHeight };
    }).observe(place);
    watchPixelRatio(() => (this.ratio.value = window.devicePixelRatio));
    this.geometry = this.followGeometry();
    this.draw();
  }

  /** Larger or smaller around the middle of what is in sight. */
  zoomBy(factor: number): void {
    const side = this.geometry.peek()?.side ?? 0;
    this.grid.zoomAt(factor, side / 2, side / 2);
  }

  private followGeometry(): ReadonlySignal<MatrixGeometry | null> {
    const { scene } = this.shared;
    const longest = computed(() =>
      longestNamePx(scene.value?.names ?? [], getComputedStyle(this.place).fontFamily),
    );
    return computed(() => {
      const { width, height } = this.size.value;
      if (!scene.value || width === 0) return null;
      const size = { width, height };
      return matrixGeometry(scene.value, size, this.zoom.value, longest.value);
    });
  }

  private draw(): void {
    const { palette, selected, hovered, context } = this.shared;
    this.withState((now) => this.drawCells(now));
    this.withState((now) => drawTree(this.tree, { ...now, palette: palette.value }));
    this.withState(({ scene, geometry }) => {
      this.groups.show(scene, geometry, context.language.words.value.t('names.no-label'));
    });
    this.withState((now) => {
      this.names.update({ ...now, selected: selected.value, hovered: hovered.value });
    });
    this.withState((now) => this.grid.update(now));
    follow(() => {
      const now = this.stateNow();
      const wanted = context.store.compare.cutClusters.value;
      const words = context.language.words.value;
      this.cut.update(now && { ...now, words, wanted });
    });
    this.withState((now) => this.drawMarks(now));
  }

  private stateNow(): GridState | null {
    const [scene, geometry] = [this.shared.scene.value, this.geometry.value];
    return scene && geometry ? { scene, geometry } : null;
  }

  /** As long as there is something to draw. */
  private withState(draw: (state: GridState) => void): void {
    follow(() => {
      const now = this.stateNow();
      if (now) draw(now);
    });
  }

  private drawCells({ scene, geometry }: GridState): void {
    void this.ratio.value;
    const palette = this.shared.palette.value;
    const { pictures } = this.shared;
    pictures.side = Math.max(1, Math.round(geometry.side * window.devicePixelRatio));
    const placed = pictures.pictureFor(scene, geometry);
    const colours = placed ? this.coloursOf(placed) : new Uint32Array();
    const font = getComputedStyle(this.place).fontFamily;
    this.cells.draw({ scene, geometry, palette, font, placed, colours });
  }

  /** A number of its own: another cut is another scene, with the same colours. */
  private readonly maximum = computed(() => this.shared.scene.value?.comparison.legendMaximum ?? 0);
  private readonly scale = computed(
    () => new ColourScale(this.shared.palette.value.distances, this.maximum.value),
  );

  private coloursOf(placed: PlacedPicture): Uint32Array {
    const scale = this.scale.value;
    if (this.coloured?.placed !== placed || this.coloured.scale !== scale)
      this.coloured = { placed, scale, colours: colourPicture(placed.picture, scale) };
    return this.coloured.colours;
  }

  private drawMarks({ scene, geometry }: GridState): void {
    const { hovered, selected } = this.shared;
    const [over, chosen] = [cellOf(scene, hovered.value), cellOf(scene, selected.value)];
    this.marks.show(geometry, over, chosen);
    const tipped = over && (this.grid.focused || this.place.matches(':hover'));
    this.tip.show(tipped ? this.tipPlace(scene, geometry, over) : null);
  }

  /** Beside the cell, or beside the name while the pointer is there. */
  private tipPlace(scene: Scene, geometry: MatrixGeometry, cell: MarkedCell) {
    const { axis, zoom, left } = geometry;
    const byName = this.names.element.matches(':hover');
    const x = byName ? left - axis.cell : left + axis.start(cell.column) - zoom.x;
    const y = topPx + axis.start(cell.row) - zoom.y;
    const box = { left: x, top: y, right: x + axis.cell, bottom: y + axis.cell };
    return { a: scene.order[cell.row], b: scene.order[cell.column], box };
  }

  private reach(position: number): void {
    const geometry = untracked(() => this.geometry.value);
    if (geometry) this.zoom.value = zoomShowing(geometry, position, position);
  }
}

function cellOf({ positionOfItem }: Scene, pair: ItemPair | null): MarkedCell | null {
  if (pair === null || pair.a === null || pair.b === null) return null;
  return { row: positionOfItem[pair.a], column: positionOfItem[pair.b] };
}
