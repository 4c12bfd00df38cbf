/** In: performers, their poses, a palette. Out: the three.js scene: background, ground, figures, ghosts, trails. */
import { Scene, type Vector3 } from 'three';
import { BackgroundView } from './background-view';
import { TEXTURE_STRIDE } from './cone-texture';
import { type Figure, FigureSet, frameOf, type Frames, type StagePerformer } from './figure-set';
import { figureMesh, FigureMaterial, type SharedUniforms } from './figure-view';
import { GhostSet, MOST_GHOSTS } from './ghost-set';
import { GhostMatter, type GhostView } from './ghost-view';
import { type GroundFigure, GroundView } from './ground-view';
import { type Palette, SUN_DIRECTION } from './palette';
import { jointOfHit, pickCone, type Ray } from './pick';
import type { StageGhost, StageTrails } from './stage-props';
import { TrailView } from './trail-view';
import { trailPaths, trailTime } from './trail-paths';

/** Metres between the lines of the grid; in body heights where the unit is unknown. */
const CELL = 0.5;
/** Ghosts at most this part as far away as before are much nearer. */
const NEARER = 0.75;

const nothingSeen = {
  first: 0,
  count: 0,
  resting: false,
  occluded: false,
  mark: 0,
  tint: null,
};

export class StageScene {
  readonly scene = new Scene();
  /** Where the figures stand and how far beyond a standing human they reach, in body heights. */
  readonly place = { x: 0, z: 0, reach: 0, above: 0, below: 0, ghosts: 0 };
  /** The ghosts in the order of their poses; null where one cannot be drawn. */
  ghostViews: readonly (GhostView | null)[] = [];
  private readonly background = new BackgroundView();
  private readonly shared: SharedUniforms = {
    cones: { value: null },
    sunDirection: { value: SUN_DIRECTION },
  };
  private readonly ground = new GroundView(this.shared);
  private readonly material = new FigureMaterial(this.shared);
  private readonly matter = new GhostMatter(this.shared);
  private readonly set = new FigureSet(this.scene, this.material, this.shared);
  private readonly ghosts = new GhostSet(this.scene, this.matter);
  private readonly trailView = new TrailView();
  private performers: readonly StagePerformer[] = [];
  private chosen = 0;
  private ghostProps: readonly StageGhost[] = [];
  private trails: StageTrails | null = null;
  private readonly shades: GroundFigure[] = [];
  /** The figures are those of former performers. */
  private outdated = false;
  /** Draw nothing, but have the shaders compiled before the first figure and the first ghost come. */
  private readonly heralds = [this.material, this.matter.veil, this.matter.skin].map((material) =>
    figureMesh(material, nothingSeen),
  );

  constructor() {
    const { background, ground, trailView } = this;
    this.scene.add(background.mesh, ground.mesh, trailView.mesh, ...this.heralds);
  }

  get figures(): readonly Figure[] {
    return this.set.figures;
  }

  /** The figures of the performers are there, and the place is theirs. */
  get ready(): boolean {
    return this.figures.length > 0 && !this.outdated;
  }

  /** Every figure has a place in the picture. */
  get drawable(): boolean {
    return this.figures.every(({ drawable }) => drawable);
  }

  get chosenFigure(): Figure | null {
    return this.figures[this.chosen] ?? null;
  }

  setPalette(palette: Palette): void {
    const { background, ground, material, matter, trailView } = this;
    for (const part of [background, ground, material, matter, trailView]) part.setPalette(palette);
  }

  setContrast(more: boolean): void {
    this.matter.setContrast(more);
  }

  /** Ghosts that darken themselves cost the most: they do only while there is time. */
  setGhostShade(shade: boolean): void {
    this.ghosts.occluded = shade;
  }

  /** New figures take the place of the old ones with the first frame whose poses are there. */
  setPerformers(performers: readonly StagePerformer[]): void {
    this.performers = performers;
    this.outdated = true;
    this.place.ghosts = 0;
    if (performers.length === 0) this.clear();
  }

  setChosen(chosen: number): void {
    if (chosen === this.chosen) return;
    this.chosen = chosen;
    if (this.ready) this.changeFigure();
  }

  setGhosts(ghosts: readonly StageGhost[]): void {
    this.ghostProps = ghosts;
    if (this.ready) this.placeGhosts();
  }

  setTrails(trails: StageTrails | null): void {
    this.trails = trails;
    if (this.ready) this.placeTrails();
  }

  /** Shows a frame, of every performer its own perhaps; false while poses are missing (the figures then stay as they were). */
  showFrame(frames: Frames): boolean {
    if (!this.set.has(this.performers, frames)) return false;
    if (this.outdated) this.replaceFigures(frames);
    this.set.showFrame(frames);
    const now = frameOf(frames, this.chosen);
    if (this.trails) this.trailView.setNow(trailTime(this.trails.frames, now));
    this.placeFigures();
    return true;
  }

  setPixelRatio(ratio: number): void {
    this.ground.setPixelRatio(ratio);
  }

  /** The middle of the grid, where it does not fade. */
  setGridCentre(x: number, z: number): void {
    this.ground.setCentre(x, z);
  }

  /** To be called before drawing from another place. */
  setEye(eye: Vector3): void {
    this.ghosts.sort(eye);
  }

  /** The figure and its joint that a ray meets first. */
  pick(ray: Ray): { readonly performer: number; readonly joint: number } | null {
    let nearest = Infinity;
    let found: { performer: number; joint: number } | null = null;
    this.figures.forEach(({ pose, first, count, drawable }, performer) => {
      const { data } = this.set.cones;
      const hit = drawable ? pickCone(data, TEXTURE_STRIDE, first, count, ray) : null;
      if (hit === null || hit.distance >= nearest) return;
      nearest = hit.distance;
      found = { performer, joint: jointOfHit(pose.bones[hit.cone], hit.along) };
    });
    return found;
  }

  dispose(): void {
    this.clear();
    for (const { geometry } of this.heralds) geometry.dispose();
    const { material, matter, set, ground, background, trailView } = this;
    for (const part of [material, matter, set, ground, background, trailView]) part.dispose();
  }

  private replaceFigures(frames: Frames): void {
    this.clear();
    this.outdated = false;
    this.set.replace(this.performers, frames, MOST_GHOSTS);
    if (this.performers.length === 0) return;
    this.ground.setCell(cellOf(this.performers[0]));
    this.changeFigure();
  }

  /** Ghosts and trails are another performer's. */
  private changeFigure(): void {
    this.place.ghosts = 0;
    this.ghosts.setFigure(this.set, this.chosenFigure ?? undefined);
    this.placeGhosts();
    this.placeTrails();
  }

  private placeGhosts(): void {
    this.ghostViews = this.ghosts.show(this.ghostProps, this.set);
    this.placeFigures();
  }

  private placeTrails(): void {
    const { trails, chosenFigure: figure } = this;
    const paths = trails && figure ? trailPaths(trails, figure.pose) : [];
    this.trailView.setPaths(paths, figure?.pose.radiusScale ?? 1);
  }

  private placeFigures(): void {
    const { place, shades, figures, chosenFigure } = this;
    measurePlace(figures, place);
    shades.length = 0;
    // The chosen one first: the ground sees it and the nearest to it in full.
    if (chosenFigure?.drawable) shades.push(chosenFigure);
    for (let i = 0; i < figures.length; i++) {
      if (figures[i].drawable && figures[i] !== chosenFigure) shades.push(figures[i]);
    }
    let farthest = 0;
    for (let i = 0; i < this.ghosts.shown.length; i++) {
      const ghost = this.ghosts.shown[i];
      shades.push(ghost);
      if (ghost.passing) continue;
      farthest = Math.max(farthest, Math.hypot(ghost.x - place.x, ghost.z - place.z));
      place.above = Math.max(place.above, ghost.pose.excessHigh);
    }
    // Much nearer, and the camera comes nearer too; else the picture would breathe from keypose to keypose.
    if (farthest > place.ghosts || farthest < NEARER * place.ghosts) place.ghosts = farthest;
    this.ground.setFigures(shades);
  }

  private clear(): void {
    this.ghosts.clear();
    this.ghostViews = [];
    this.set.clear();
    this.trailView.setPaths([], 1);
    this.ground.setFigures([]);
  }
}

type Place = StageScene['place'];

/** Of the figures that can be drawn; without any the place stays. */
function measurePlace(figures: readonly Figure[], place: Place): void {
  let [count, x, z] = [0, 0, 0];
  for (let i = 0; i < figures.length; i++) {
    if (!figures[i].drawable) continue;
    count++;
    x += figures[i].pose.middleX;
    z += figures[i].pose.middleZ;
  }
  if (count === 0) return;
  place.x = x / count;
  place.z = z / count;
  place.reach = place.above = place.below = 0;
  for (let i = 0; i < figures.length; i++) {
    const { pose, drawable } = figures[i];
    if (!drawable) continue;
    const away = Math.hypot(pose.middleX - place.x, pose.middleZ - place.z);
    place.reach = Math.max(place.reach, away + pose.excess);
    place.above = Math.max(place.above, pose.excessHigh);
    place.below = Math.max(place.below, pose.excessLow);
  }
}

function cellOf(performer: StagePerformer): number {
  const { unit, body } = performer;
  return unit && body.height > 0 ? CELL / (unit.metres * body.height) : CELL;
}
