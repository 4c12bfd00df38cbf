/** In: an element, performers and their poses, a frame. Out: the figures on their ground, drawn by WebGL2. */
import './stage.css';
import { createDrawing, type Drawing, noMetrics } from './drawing';
import type { Frames } from './figure-set';
import type { StageMetrics, StageProps } from './stage-props';
import type { Look, Stance, ViewPreset } from './view';

/**
 * A view: `update` changes properties, `show` asks for a frame, `destroy` ends it. Nothing is drawn
 * while nothing changes.
 */
export class Stage {
  private props: StageProps;
  private readonly target: HTMLElement;
  private readonly drawing: Drawing | null;

  constructor(target: HTMLElement, props: StageProps) {
    this.target = target;
    this.props = props;
    target.classList.add('stage-target');
    this.drawing = props.off ? null : createDrawing(target, props);
    if (!props.off && this.drawing === null) props.onFailure?.('no-webgl2');
  }

  /** Properties that are left out stay as they are. */
  update(change: Partial<StageProps>): void {
    const before = this.props;
    this.props = { ...before, ...change };
    this.drawing?.setProps(this.props, before);
  }

  /** Asks for a frame of the clip, or of each performer's own; drawn with the browser's next frame. */
  show(frames: Frames): void {
    this.drawing?.show(frames);
  }

  /** Frames the figures anew from a preset, also when that is the current one. */
  frameView(preset: ViewPreset): void {
    this.props = { ...this.props, view: preset };
    this.drawing?.frameView(preset);
  }

  /** Turns the view around the figures by a quarter. */
  turn(): void {
    this.drawing?.turn();
  }

  /** Looks from where another stage's camera does. */
  lookFrom(look: Look): void {
    this.drawing?.lookFrom(look);
  }

  /** From where it looks; null where nothing can be drawn. */
  stance(): Stance | null {
    return this.drawing?.rig.stance ?? null;
  }

  /** Shows and draws a frame at once, not with the browser's next: for measurements. */
  drawFrame(frames: Frames): void {
    this.drawing?.drawFrame(frames);
  }

  metrics(): StageMetrics {
    return this.drawing?.metrics() ?? noMetrics;
  }

  /** The picture as PNG; rejects where nothing can be drawn. */
  snapshot(): Promise<Blob> {
    return this.drawing?.snapshot() ?? Promise.reject(new Error('The stage draws nothing'));
  }

  destroy(): void {
    this.drawing?.destroy();
    this.target.classList.remove('stage-target');
  }
}
