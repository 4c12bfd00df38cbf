/** In: a canvas, what a ray meets. Out: the place under a resting pointer, and presses that are no drags. */
import { type PerspectiveCamera, Vector3 } from 'three';
import type { Ray } from './pick';
import type { StageHit } from './stage-props';

/** A pointer that moved farther between down and up has turned the figure. */
const DRAG_PX = 4;

type Found = Pick<StageHit, 'performer' | 'joint'> | null;

export interface PickerEvents {
  pick(ray: Ray): Found;
  onHover(hit: StageHit | null): void;
  onPress(hit: StageHit): void;
}

export class Picker {
  private readonly canvas: HTMLCanvasElement;
  private readonly camera: PerspectiveCamera;
  private readonly events: PickerEvents;
  private readonly origin = new Vector3();
  private readonly direction = new Vector3();
  private readonly ends = new AbortController();
  private down: { readonly x: number; readonly y: number } | null = null;
  private hovered: Found = null;

  constructor(canvas: HTMLCanvasElement, camera: PerspectiveCamera, events: PickerEvents) {
    this.canvas = canvas;
    this.camera = camera;
    this.events = events;
    const { signal } = this.ends;
    canvas.addEventListener('pointerdown', this.onDown, { signal });
    canvas.addEventListener('pointerup', this.onUp, { signal });
    canvas.addEventListener('pointermove', this.onMove, { signal });
    canvas.addEventListener('pointerleave', this.leave, { signal });
    canvas.addEventListener('pointercancel', this.leave, { signal });
  }

  dispose(): void {
    this.ends.abort();
  }

  private readonly onDown = (event: PointerEvent): void => {
    this.down =
      event.isPrimary && event.button === 0 ? { x: event.clientX, y: event.clientY } : null;
    this.hover(null, event);
  };

  private readonly onUp = (event: PointerEvent): void => {
    const { down } = this;
    this.down = null;
    if (down === null) return;
    if (Math.hypot(event.clientX - down.x, event.clientY - down.y) > DRAG_PX) return;
    const found = this.find(event);
    if (found) this.events.onPress({ ...found, ...this.placeOf(event) });
  };

  /** A finger has no place while it does not press. */
  private readonly onMove = (event: PointerEvent): void => {
    if (event.pointerType !== 'touch' && event.buttons === 0) this.hover(this.find(event), event);
  };

  private readonly leave = (event: PointerEvent): void => {
    this.down = null;
    this.hover(null, event);
  };

  private hover(found: Found, event: PointerEvent): void {
    const before = this.hovered;
    if (found?.performer === before?.performer && found?.joint === before?.joint) return;
    this.hovered = found;
    this.canvas.classList.toggle('pointing', found !== null);
    this.events.onHover(found && { ...found, ...this.placeOf(event) });
  }

  private placeOf({ clientX, clientY }: PointerEvent): { readonly x: number; readonly y: number } {
    const { left, top } = this.canvas.getBoundingClientRect();
    return { x: clientX - left, y: clientY - top };
  }

  private find(event: PointerEvent): Found {
    const { camera, origin, direction } = this;
    const { x, y } = this.placeOf(event);
    const { clientWidth, clientHeight } = this.canvas;
    camera.updateMatrixWorld();
    origin.setFromMatrixPosition(camera.matrixWorld);
    direction.set((x / clientWidth) * 2 - 1, 1 - (y / clientHeight) * 2, 0.5);
    direction.unproject(camera).sub(origin).normalize();
    return this.events.pick({ origin: origin.toArray(), direction: direction.toArray() });
  }
}
