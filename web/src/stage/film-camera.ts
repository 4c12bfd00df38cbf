/** In: a stance on the screen, what is framed picture by picture. Out: a camera that follows by the film's own time. */
import { PerspectiveCamera } from 'three';
import { FollowPoint } from './follow';
import { eyeOf, type Framing, LENS_DEGREES, type Stance, viewOf } from './view';

/** What is framed in the film's shape and in the stage's. */
export interface Framed {
  readonly here: Framing;
  readonly onStage: Framing;
}

export class FilmCamera {
  readonly camera: PerspectiveCamera;
  private readonly point = new FollowPoint();
  private placed = false;

  constructor(
    private readonly stance: Stance,
    private readonly follow: boolean,
    aspect: number,
  ) {
    this.camera = new PerspectiveCamera(LENS_DEGREES, aspect, 0.05, 80);
  }

  /** Where it looks, over the ground. */
  get targetX(): number {
    return this.point.targetX + this.stance.offsetX;
  }
  get targetZ(): number {
    return this.point.targetZ + this.stance.offsetZ;
  }

  /** The next picture, so many seconds of the film after the last. */
  step(framed: Framed, dtS: number): void {
    if (!this.placed) this.point.jumpTo(this.first(framed));
    else if (this.follow) this.point.step(framed.here, dtS, true);
    this.placed = true;
    const view = viewOf(this.stance, this.point);
    const { x, y, z } = eyeOf(view);
    this.camera.position.set(x, y, z);
    this.camera.lookAt(view.targetX, view.targetY, view.targetZ);
  }

  /** A camera that does not follow looks where the stage's does, from as far as this shape needs. */
  private first({ here, onStage }: Framed): Framing {
    const { framed } = this.stance;
    if (this.follow) return here;
    return { ...framed, distance: (framed.distance * here.distance) / onStage.distance };
  }
}
