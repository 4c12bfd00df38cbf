/** In: where the figure is, passing seconds. Out: where a calm camera looks; no three.js. */

/** Time in which the camera makes up 63 % of its distance to the figure. */
const TIME_CONSTANT_S = 0.18;
/** Below this, in body heights, the camera has arrived. */
const ARRIVED = 5e-4;
/** A leap of the figure (a jump in time) beyond this is followed at once. */
const LEAP = 1.5;

/** The point on the ground that the camera keeps in the middle. */
export class FollowPoint {
  x = 0;
  z = 0;

  jumpTo(x: number, z: number): void {
    this.x = x;
    this.z = z;
  }

  /** Moves towards (x, z); true while there is more to go. */
  step(x: number, z: number, dtS: number, smooth: boolean): boolean {
    const gap = Math.hypot(x - this.x, z - this.z);
    if (!smooth || gap > LEAP || gap < ARRIVED) {
      this.jumpTo(x, z);
      return false;
    }
    const part = 1 - Math.exp(-dtS / TIME_CONSTANT_S);
    this.x += (x - this.x) * part;
    this.z += (z - this.z) * part;
    return true;
  }
}
