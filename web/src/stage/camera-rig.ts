/** In: presets, mouse, touch, keys, the figure's place. Out: the camera. */
import { PerspectiveCamera } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { FollowPoint } from './follow';
import {
  eased,
  eyeOf,
  type Framing,
  LENS_DEGREES,
  type Look,
  mixViews,
  shortestTurn,
  type Stance,
  type View,
} from './view';

const CAMERA_MS = 240;
const NEAREST = 0.5;
const FARTHEST = 16;
/** The camera may look up from just above the ground. */
const LOWEST_POLAR_RAD = Math.PI / 2 + 0.1;
/** A camera turned less than this still shows its preset. */
const SAME_ANGLE_RAD = 1e-3;
const KEY_TURN_RAD = Math.PI / 36;
const KEY_PAN_PX = 24;
const KEY_ZOOM = 0.92;

export interface CameraEvents {
  /** The picture is another one. */
  onMove(): void;
  /** The user turned the camera away from where it was put. */
  onTurn(): void;
  /** The user looks from there now. */
  onLook(look: Look): void;
}

const noView = (): View => ({
  yawRad: 0,
  elevationRad: 0,
  distance: 4,
  targetX: 0,
  targetY: 0.5,
  targetZ: 0,
});

export class CameraRig {
  readonly camera = new PerspectiveCamera(LENS_DEGREES, 1, 0.05, 80);
  private readonly controls: OrbitControls;
  private readonly canvas: HTMLCanvasElement;
  private readonly events: CameraEvents;
  private readonly follow = new FollowPoint();
  private readonly from = noView();
  private readonly to = noView();
  private readonly now = noView();
  private placedYaw = 0;
  private placedElevation = 0;
  /** 1 = no move under way. */
  private progress = 1;
  /** Own changes are not the user's. */
  private quiet = false;

  constructor(canvas: HTMLCanvasElement, events: CameraEvents) {
    this.canvas = canvas;
    this.events = events;
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.minDistance = NEAREST;
    this.controls.maxDistance = FARTHEST;
    this.controls.maxPolarAngle = LOWEST_POLAR_RAD;
    this.controls.addEventListener('start', this.stopMove);
    this.controls.addEventListener('change', this.onChange);
    canvas.addEventListener('keydown', this.onKey);
  }

  get targetX(): number {
    return this.controls.target.x;
  }
  get targetZ(): number {
    return this.controls.target.z;
  }

  /** Where the camera stands, beside what was framed for it; at the end of a move that is under way. */
  get stance(): Stance {
    const { targetX, targetY, targetZ, distance } = this.follow;
    if (this.progress < 1) Object.assign(this.now, this.to);
    else this.readView(this.now);
    const { now } = this;
    return {
      framed: { targetX, targetY, targetZ, distance },
      aspect: this.camera.aspect,
      yawRad: now.yawRad,
      elevationRad: now.elevationRad,
      zoom: now.distance / distance,
      offsetX: now.targetX - targetX,
      offsetY: now.targetY - targetY,
      offsetZ: now.targetZ - targetZ,
    };
  }

  setAspect(aspect: number): void {
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
  }

  /** Puts the camera there, at once or by a short move. */
  place(view: View, animated: boolean): void {
    this.follow.jumpTo(view);
    this.placedYaw = view.yawRad;
    this.placedElevation = view.elevationRad;
    this.readView(this.from);
    Object.assign(this.to, view);
    this.progress = animated ? 0 : 1;
    if (!animated) this.apply(view);
    this.events.onMove();
  }

  /** Goes around the target, at once or by a short move; what is followed stays followed. */
  turn(byRad: number, animated: boolean): void {
    const resting = this.progress >= 1;
    this.readView(this.from);
    if (resting) Object.assign(this.to, this.from);
    this.to.yawRad += byRad;
    this.progress = animated ? 0 : 1;
    if (!animated) this.apply(this.to);
    this.events.onMove();
  }

  /** Looks at what it looks at from elsewhere, as another camera does. */
  lookFrom({ yawRad, elevationRad, distance }: Look): void {
    this.stopMove();
    this.readView(this.now);
    Object.assign(this.now, { yawRad, elevationRad, distance });
    this.apply(this.now);
    this.events.onMove();
  }

  /** Lets time pass; true while the camera is still on its way. */
  step(dtS: number, smooth: boolean, followed: Framing | null): boolean {
    const moving = this.stepMove(dtS);
    if (followed === null) return moving;
    const { targetX, targetY, targetZ, distance } = this.follow;
    const following = this.follow.step(followed, dtS, smooth);
    const { follow } = this;
    this.shift(follow.targetX - targetX, follow.targetY - targetY, follow.targetZ - targetZ);
    this.recede(follow.distance / distance);
    return moving || following;
  }

  /** From now on the camera keeps what is framed in the middle. */
  startFollowing(followed: Framing): void {
    const { x: targetX, z: targetZ } = this.controls.target;
    this.follow.jumpTo({ ...followed, targetX, targetZ });
    const gap = Math.hypot(followed.targetX - targetX, followed.targetZ - targetZ);
    if (gap > 0) this.events.onMove();
  }

  dispose(): void {
    this.canvas.removeEventListener('keydown', this.onKey);
    this.controls.dispose();
  }

  private stepMove(dtS: number): boolean {
    if (this.progress >= 1) return false;
    this.progress = Math.min(1, this.progress + (dtS * 1000) / CAMERA_MS);
    mixViews(this.from, this.to, eased(this.progress), this.now);
    this.apply(this.now);
    return this.progress < 1;
  }

  private shift(dx: number, dy: number, dz: number): void {
    if (dx === 0 && dy === 0 && dz === 0) return;
    for (const view of [this.from, this.to]) {
      view.targetX += dx;
      view.targetY += dy;
      view.targetZ += dz;
    }
    for (const point of [this.camera.position, this.controls.target]) {
      point.x += dx;
      point.y += dy;
      point.z += dz;
    }
    this.update();
  }

  /** Goes `ratio` times as far away: what the user zoomed stays zoomed. */
  private recede(ratio: number): void {
    if (ratio === 1) return;
    this.from.distance *= ratio;
    this.to.distance *= ratio;
    const { position } = this.camera;
    const { target } = this.controls;
    position.sub(target).multiplyScalar(ratio).add(target);
    this.update();
  }

  private apply(view: View): void {
    this.controls.target.set(view.targetX, view.targetY, view.targetZ);
    this.camera.position.copy(eyeOf(view));
    this.update();
  }

  private readView(out: View): void {
    out.yawRad = this.controls.getAzimuthalAngle();
    out.elevationRad = Math.PI / 2 - this.controls.getPolarAngle();
    out.distance = this.controls.getDistance();
    out.targetX = this.controls.target.x;
    out.targetY = this.controls.target.y;
    out.targetZ = this.controls.target.z;
  }

  private update(): void {
    this.quiet = true;
    this.controls.update();
    this.quiet = false;
  }

  private readonly stopMove = (): void => {
    this.progress = 1;
  };

  private readonly onChange = (): void => {
    if (this.quiet) return;
    this.readView(this.now);
    const turned = Math.abs(shortestTurn(this.placedYaw, this.now.yawRad)) > SAME_ANGLE_RAD;
    const tilted = Math.abs(this.placedElevation - this.now.elevationRad) > SAME_ANGLE_RAD;
    this.events.onMove();
    this.events.onLook(this.now);
    if (turned || tilted) this.events.onTurn();
  };

  /** Arrows turn, with Shift they move, + and − zoom; only while the stage has the keyboard. */
  private readonly onKey = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey || !this.obey(event.key, event.shiftKey))
      return;
    event.preventDefault();
    event.stopPropagation();
  };

  private obey(key: string, shift: boolean): boolean {
    const [across, down] = ARROWS[key] ?? [0, 0];
    this.stopMove();
    if (across !== 0 || down !== 0) {
      if (shift) this.controls.pan(-across * KEY_PAN_PX, -down * KEY_PAN_PX);
      else if (across !== 0) this.controls.rotateLeft(across * KEY_TURN_RAD);
      else this.controls.rotateUp(down * KEY_TURN_RAD);
    } else if (key === '+' || key === '=') this.controls.dollyIn(KEY_ZOOM);
    else if (key === '-') this.controls.dollyOut(KEY_ZOOM);
    else return false;
    return true;
  }
}

const ARROWS: Readonly<Record<string, readonly [number, number] | undefined>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};
