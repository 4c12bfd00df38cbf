/** In: where the figure is, passing seconds. Out: where a calm camera looks; no three.js. */
import type { Framing } from './view';

/** Time in which the camera makes up 63 % of its distance to the figure. */
const TIME_CONSTANT_S = 0.18;
/** Below this, in body heights, the camera has arrived. */
const ARRIVED = 5e-4;
/** A leap of the figure (a jump in time) beyond this is followed at once. */
const LEAP = 1.5;

/** What the camera keeps in the middle, and how far away it stands to keep it whole. */
export class FollowPoint implements Framing {
  targetX = 0;
  targetY = 0;
  targetZ = 0;
  distance = 1;

  jumpTo({ targetX, targetY, targetZ, distance }: Framing): void {
    this.targetX = targetX;
    this.targetY = targetY;
    this.targetZ = targetZ;
    this.distance = distance;
  }

  /** Moves towards another framing; true while there is more to go. */
  step(to: Framing, dtS: number, smooth: boolean): boolean {
    const moved = Math.hypot(to.targetX - this.targetX, to.targetZ - this.targetZ);
    const gap = moved + Math.abs(to.targetY - this.targetY) + Math.abs(to.distance - this.distance);
    if (!smooth || moved > LEAP || gap < ARRIVED) {
      this.jumpTo(to);
      return false;
    }
    const part = 1 - Math.exp(-dtS / TIME_CONSTANT_S);
    this.targetX += (to.targetX - this.targetX) * part;
    this.targetY += (to.targetY - this.targetY) * part;
    this.targetZ += (to.targetZ - this.targetZ) * part;
    this.distance += (to.distance - this.distance) * part;
    return true;
  }
}
