/**
 * The latest scene in; the scene whose picture is there, and its pictures, out: until the picture of a
 * new order has arrived the old one stays.
 */
import { batch, signal } from '@preact/signals-core';
import type { Comparer, MatrixRegion } from '../engine/comparison-types';
import { positionsInSight } from './matrix-canvas';
import type { MatrixGeometry } from './matrix-geometry';
import { isExact, type PlacedPicture } from './matrix-pixels';
import type { Scene } from './scene';

/** Up to so many clips the whole matrix is one exact picture. */
const mostExact = 1024;
/** Before the matrix has a place on the page. */
const usualSide = 600;
const mostDetail = 1280;

const sameOrder = (a: Int32Array, b: Int32Array): boolean =>
  a === b || (a.length === b.length && a.every((item, k) => item === b[k]));

/** Of more clips a picture has no more rows than the page has pixels: each is the mean of its cells. */
const whole = (scene: Scene, side: number): MatrixRegion => ({
  order: scene.order,
  firstRow: 0,
  rowCount: scene.count,
  firstColumn: 0,
  columnCount: scene.count,
  most: scene.count <= mostExact ? mostExact : Math.min(mostExact, side),
});

export class PictureSource {
  readonly scene = signal<Scene | null>(null);
  readonly overview = signal<PlacedPicture | null>(null);
  readonly detail = signal<PlacedPicture | null>(null);
  /** Pixels of the device along a side of the matrix. */
  side = usualSide;
  private latest: Scene | null = null;
  private asking = false;
  private wanted: MatrixRegion | null = null;

  constructor(private readonly comparer: Pick<Comparer, 'picture'>) {}

  /** Call with every new scene. */
  follow(latest: Scene | null): void {
    this.latest = latest;
    const shown = this.scene.peek();
    const known =
      latest !== null &&
      shown?.comparison === latest.comparison &&
      sameOrder(shown.order, latest.order);
    if (latest === null || known) this.show(latest, null);
    else void this.begin(latest);
  }

  private async begin(scene: Scene): Promise<void> {
    const region = whole(scene, this.side);
    const picture = await this.comparer.picture(region).catch(() => null);
    // Where there is no picture, names, tree and map still tell of the set.
    if (this.latest === scene) this.show(scene, picture && { region, picture });
    else if (this.latest?.comparison === scene.comparison && picture) this.follow(this.latest);
  }

  private show(scene: Scene | null, placed: PlacedPicture | null): void {
    const another = this.scene.peek()?.comparison !== scene?.comparison || placed !== null;
    batch(() => {
      this.scene.value = scene;
      if (!another) return;
      this.overview.value = placed;
      this.detail.value = null;
    });
    if (placed && performance.getEntriesByName(firstPicture).length === 0)
      performance.mark(firstPicture);
  }

  /** The best picture of what is in sight; a better one is asked for. */
  pictureFor(scene: Scene, geometry: MatrixGeometry): PlacedPicture | null {
    const [overview, detail] = [this.overview.value, this.detail.value];
    if (!overview || isExact(overview) || geometry.zoom.cell === null) return overview;
    const region = regionInSight(scene, geometry);
    const covers = detail !== null && coversSight(detail, scene, geometry);
    if (!covers) this.ask(region);
    return covers ? detail : overview;
  }

  private ask(region: MatrixRegion): void {
    this.wanted = region;
    if (this.asking) return;
    this.asking = true;
    const scene = this.scene.peek();
    this.wanted = null;
    this.comparer
      .picture(region)
      .then((picture) => {
        if (this.scene.peek() === scene) this.detail.value = { region, picture };
      })
      .catch(() => null)
      .finally(() => {
        this.asking = false;
        if (this.wanted) this.ask(this.wanted);
      });
  }
}

const firstPicture = 'comparison-first-picture';

interface Run {
  readonly first: number;
  readonly count: number;
}

/** What is in sight and half as much on either side, so that a pan finds its picture there. */
function padded({ first, end }: { first: number; end: number }, count: number): Run {
  const margin = Math.ceil((end - first) / 2);
  const from = Math.max(0, first - margin);
  return { first: from, count: Math.min(count, end + margin) - from };
}

function regionInSight(scene: Scene, geometry: MatrixGeometry): MatrixRegion {
  const rows = padded(positionsInSight(geometry, geometry.zoom.y), scene.count);
  const columns = padded(positionsInSight(geometry, geometry.zoom.x), scene.count);
  return {
    order: scene.order,
    firstRow: rows.first,
    rowCount: rows.count,
    firstColumn: columns.first,
    columnCount: columns.count,
    most: Math.min(mostDetail, Math.max(rows.count, columns.count)),
  };
}

const finer = 0.99;

/** Whether a picture reaches over what is in sight with as much detail as a new one would have. */
function coversSight(
  { region, picture }: PlacedPicture,
  scene: Scene,
  geometry: MatrixGeometry,
): boolean {
  const rows = positionsInSight(geometry, geometry.zoom.y);
  const columns = positionsInSight(geometry, geometry.zoom.x);
  const wanted = regionInSight(scene, geometry);
  const detail = Math.min(1, wanted.most / Math.max(wanted.rowCount, wanted.columnCount));
  return (
    sameOrder(region.order, scene.order) &&
    region.firstRow <= rows.first &&
    region.firstRow + region.rowCount >= rows.end &&
    region.firstColumn <= columns.first &&
    region.firstColumn + region.columnCount >= columns.end &&
    picture.rows / region.rowCount >= finer * detail
  );
}
