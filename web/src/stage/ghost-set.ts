/** In: poses of the chosen performer at other moments. Out: its ghosts in the scene. */
import type { Scene, Vector3 } from 'three';
import type { Figure, FigureSet } from './figure-set';
import { type GhostMatter, GhostView } from './ghost-view';
import type { StageGhost } from './stage-props';

const fartherFirst = (a: GhostView, b: GhostView): number => b.distance - a.distance;

const nobody: StageGhost = { tag: '', pose: new Float32Array() };

/** At two keyposes before and two after, and at the moment under the pointer. */
export const MOST_GHOSTS = 5;

export class GhostSet {
  private readonly scene: Scene;
  private readonly matter: GhostMatter;
  private ghosts: GhostView[] = [];
  /** Those shown, the farthest from the eye first. */
  readonly shown: GhostView[] = [];

  constructor(scene: Scene, matter: GhostMatter) {
    this.scene = scene;
    this.matter = matter;
  }

  /** Ghosts of another figure. */
  setFigure({ cones, spare }: FigureSet, figure: Figure | undefined): void {
    this.clear();
    if (figure === undefined) return;
    const { bones } = figure.pose;
    this.ghosts = Array.from({ length: MOST_GHOSTS }, (_, i) => {
      const first = spare + i * bones.length;
      cones.setBones(bones, first);
      return new GhostView(this.matter, figure.pose.twin(), first, i + 1, figure.tint);
    });
    for (const ghost of this.ghosts) ghost.addTo(this.scene);
  }

  /** Which of the ghosts can be shown, in their order. */
  show(props: readonly StageGhost[], { cones }: FigureSet): (GhostView | null)[] {
    this.shown.length = 0;
    const views = this.ghosts.map((ghost, i) => {
      const { pose, tag } = props[i] ?? nobody;
      const fits = pose.length === ghost.pose.joints.length;
      ghost.visible = fits && ghost.pose.writePose(pose, cones, ghost.first);
      ghost.passing = tag === '';
      if (!ghost.visible) return null;
      ghost.place();
      this.shown.push(ghost);
      return ghost;
    });
    cones.changed();
    return views;
  }

  set occluded(occluded: boolean) {
    for (const ghost of this.ghosts) ghost.occluded = occluded;
  }

  /** The farthest is drawn first. */
  sort(eye: Vector3): void {
    const { shown } = this;
    for (let i = 0; i < shown.length; i++) {
      shown[i].distance = Math.hypot(shown[i].x - eye.x, shown[i].z - eye.z);
    }
    shown.sort(fartherFirst);
    for (let i = 0; i < shown.length; i++) shown[i].order = i;
  }

  clear(): void {
    for (const ghost of this.ghosts) ghost.removeFrom(this.scene);
    this.ghosts = [];
    this.shown.length = 0;
  }
}
