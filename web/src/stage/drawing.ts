/** In: a stage's properties and frames. Out: pictures on a canvas, one when something changed, else none. */
import { WebGLRenderer } from 'three';
import { CameraRig } from './camera-rig';
import { frameOf, type Frames, type StagePerformer } from './figure-set';
import { readPalette } from './palette';
import { Picker } from './picker';
import { Quality } from './quality';
import { sameWorld } from './same-world';
import type { StageMetrics, StageProps } from './stage-props';
import { StageScene } from './stage-scene';
import { StageTags } from './stage-tags';
import { uniformVectors } from './uniform-count';
import { type Framing, framing, type Look, presetView, type ViewPreset } from './view';

const MOST_PIXEL_RATIO = 2;
/** The time that a frame after a rest stands for. */
const FIRST_STEP_MS = 16;
/** The empty stage is seen from anywhere. */
const NO_YAWS = { frontYawRad: 0, sideYawRad: 0.5 };
const LONGEST_STEP_MS = 250;
/** Width below which the tools over the stage leave its middle no room, and their height. */
const NARROW_PX = 560;
const TOOLS_PX = 40;

/** null where the browser has no WebGL2. */
export function createDrawing(target: HTMLElement, props: StageProps): Drawing | null {
  const canvas = document.createElement('canvas');
  canvas.className = 'stage-canvas';
  canvas.tabIndex = 0;
  // Ghosts mark what they cover.
  const context = canvas.getContext('webgl2', { antialias: true, alpha: false, stencil: true });
  if (context === null) return null;
  target.append(canvas);
  return new Drawing(target, canvas, new WebGLRenderer({ canvas, context }), props);
}

/** What a stage without graphics tells. */
export const noMetrics: StageMetrics = {
  drawCalls: 0,
  triangles: 0,
  framesDrawn: 0,
  lastFrameMs: 0,
  uniformVectors: 0,
  reduced: false,
};

export class Drawing {
  private readonly target: HTMLElement;
  private readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new StageScene();
  readonly rig: CameraRig;
  private readonly quality = new Quality();
  private readonly tags: StageTags;
  private readonly picker: Picker;
  /** Where tags may be. */
  private readonly area = { width: 0, height: 0, left: 0, right: 0 };
  private readonly observer: ResizeObserver;
  private props: StageProps;
  private preset: ViewPreset | null;
  private ends: (() => void)[] = [];
  private width = 0;
  private height = 0;
  private frames: Frames = 0;
  private direction: -1 | 0 | 1 = 0;
  private posesStale = true;
  private drawable = true;
  private unframed = true;
  /** The camera is still on its way. */
  private moving = false;
  private lost = false;
  private request = 0;
  private requestedMs = 0;
  private drawnMs = -Infinity;
  private framesDrawn = 0;
  private lastFrameMs = 0;

  constructor(
    target: HTMLElement,
    canvas: HTMLCanvasElement,
    renderer: WebGLRenderer,
    props: StageProps,
  ) {
    this.target = target;
    this.canvas = canvas;
    this.renderer = renderer;
    this.props = props;
    this.preset = props.view;
    this.rig = new CameraRig(canvas, {
      onMove: this.requestDraw,
      onTurn: this.onTurn,
      onLook: (look) => this.props.onLook?.(look),
    });
    canvas.addEventListener('mousedown', keepFocus);
    canvas.addEventListener('webglcontextlost', this.onLost);
    canvas.addEventListener('webglcontextrestored', this.onRestored);
    this.rig.place(presetView('side', NO_YAWS, 1, this.scene.place), false);
    this.picker = new Picker(canvas, this.rig.camera, {
      pick: (ray) => this.scene.pick(ray),
      onHover: (hit) => this.props.onHover?.(hit),
      onPress: (hit) => this.props.onPick?.(hit),
    });
    this.tags = new StageTags(target);
    this.tags.setProps(props);
    this.setLabel(props);
    this.scene.setPalette(readPalette(target, props.theme));
    this.setPerformers(props.performers);
    this.setMoments(props);
    this.observer = new ResizeObserver(this.onResize);
    this.observer.observe(target);
  }

  setProps(props: StageProps, before: StageProps): void {
    this.props = props;
    this.setLabel(props);
    if (props.theme !== before.theme) this.scene.setPalette(readPalette(this.target, props.theme));
    if (props.performers !== before.performers) {
      this.unframed ||= !sameWorld(props.performers, before.performers);
      this.setPerformers(props.performers);
    }
    Object.assign(this.area, props.corners);
    this.setMoments(props, before);
    this.tags.setProps(props);
    if (props.follow && !before.follow) this.rig.startFollowing(this.framing());
    if (props.view !== null && props.view !== before.view) this.frameView(props.view);
    this.requestDraw();
  }

  show(frames: Frames): void {
    const before = this.frames;
    // Also of performers that are still to come.
    this.frames = frames;
    const same = this.props.performers.every((_, i) => frameOf(frames, i) === frameOf(before, i));
    if (same && !this.posesStale) return;
    this.direction = Math.sign(frameOf(frames, 0) - frameOf(before, 0)) as -1 | 0 | 1;
    this.posesStale = true;
    this.requestDraw();
  }

  frameView(preset: ViewPreset): void {
    this.preset = preset;
    const performer = this.props.performers[0] as StagePerformer | undefined;
    if (performer === undefined || !this.scene.ready) return;
    const view = presetView(
      preset,
      performer,
      this.width / this.height,
      this.scene.place,
      this.headroom,
      this.props.room,
    );
    this.rig.place(view, !this.unframed && !this.props.reducedMotion);
    this.unframed = false;
  }

  /** Turns the camera around the figures by a quarter. */
  turn(): void {
    this.rig.turn(Math.PI / 2, !this.props.reducedMotion);
    this.onTurn();
  }

  lookFrom(look: Look): void {
    this.rig.lookFrom(look);
  }

  /** Shows and draws a frame at once: for measurements. */
  drawFrame(frames: Frames): void {
    this.show(frames);
    this.drawNow(performance.now());
  }

  metrics(): StageMetrics {
    const { info } = this.renderer;
    const { framesDrawn, lastFrameMs } = this;
    const programs = info.programs?.map(({ program }) => program as WebGLProgram) ?? [];
    return {
      drawCalls: info.render.calls,
      triangles: info.render.triangles,
      framesDrawn,
      lastFrameMs,
      uniformVectors: uniformVectors(
        this.renderer.getContext() as WebGL2RenderingContext,
        programs,
      ),
      reduced: this.quality.reduced,
    };
  }

  snapshot(): Promise<Blob> {
    this.drawNow(performance.now());
    return new Promise((resolve, reject) => {
      this.canvas.toBlob((blob) => {
        if (blob) resolve(blob);
        else reject(new Error('The stage could not be saved as a picture'));
      });
    });
  }

  destroy(): void {
    cancelAnimationFrame(this.request);
    this.observer.disconnect();
    for (const end of this.ends) end();
    this.canvas.removeEventListener('webglcontextlost', this.onLost);
    this.canvas.removeEventListener('webglcontextrestored', this.onRestored);
    this.picker.dispose();
    this.tags.destroy();
    this.rig.dispose();
    // A page has few contexts: this one is given back now, not when memory is tidied.
    this.renderer.forceContextLoss();
    this.scene.dispose();
    this.renderer.dispose();
    this.canvas.remove();
  }

  private setLabel({ label }: StageProps): void {
    this.canvas.setAttribute('role', 'img');
    if (label !== undefined) this.canvas.setAttribute('aria-label', label);
  }

  /** Ghosts, trails, and whose they are. */
  private setMoments(props: StageProps, before?: StageProps): void {
    const { chosen, ghosts, trails, moreContrast } = props;
    this.scene.setChosen(chosen);
    if (ghosts !== before?.ghosts) this.scene.setGhosts(ghosts);
    if (trails !== before?.trails) {
      this.scene.setTrails(trails);
      // The playhead on the new paths.
      this.posesStale = true;
    }
    this.scene.setContrast(moreContrast);
  }

  private setPerformers(performers: readonly StagePerformer[]): void {
    for (const end of this.ends) end();
    this.ends = performers.map(({ source }) => source.onArrive(this.onArrive));
    this.scene.setPerformers(performers);
    this.posesStale = true;
    this.requestDraw();
  }

  private readonly onArrive = (): void => {
    if (this.posesStale) this.requestDraw();
  };

  private readonly onTurn = (): void => {
    if (this.preset === null) return;
    this.preset = null;
    this.props.onViewChange?.(null);
  };

  private readonly onResize = (): void => {
    this.width = this.target.clientWidth;
    this.height = this.target.clientHeight;
    Object.assign(this.area, { width: this.width, height: this.height });
    if (this.width === 0 || this.height === 0) return;
    this.setSize();
    // The canvas is empty now: drawn in the same frame it does not flicker.
    this.drawNow(performance.now());
  };

  private setSize(): void {
    const ratio = this.quality.reduced ? 1 : Math.min(window.devicePixelRatio, MOST_PIXEL_RATIO);
    this.renderer.setPixelRatio(ratio);
    this.scene.setPixelRatio(ratio);
    this.scene.setGhostShade(!this.quality.reduced);
    this.renderer.setSize(this.width, this.height, false);
    this.rig.setAspect(this.width / this.height);
  }

  private readonly onLost = (event: Event): void => {
    event.preventDefault();
    this.lost = true;
    this.props.onFailure?.('context-lost');
  };

  private readonly onRestored = (): void => {
    this.lost = false;
    this.posesStale = true;
    this.props.onRecovery?.();
    this.requestDraw();
  };

  private readonly requestDraw = (): void => {
    if (this.request !== 0) return;
    this.requestedMs = performance.now();
    this.request = requestAnimationFrame(this.drawRequested);
  };

  private readonly drawRequested = (nowMs: number): void => {
    this.request = 0;
    if (this.quality.frame(performance.now() - this.requestedMs)) this.setSize();
    this.drawNow(nowMs);
  };

  private drawNow(nowMs: number): void {
    if (this.lost || this.width === 0 || this.height === 0) return;
    const startMs = performance.now();
    if (this.posesStale) this.readPoses();
    if (this.unframed && this.scene.ready) this.frameFirst();
    this.moveCamera(nowMs);
    this.scene.setGridCentre(this.rig.targetX, this.rig.targetZ);
    this.scene.setEye(this.rig.camera.position);
    this.renderer.render(this.scene.scene, this.rig.camera);
    this.tags.place(this.scene, this.rig.camera, this.area);
    this.framesDrawn++;
    this.lastFrameMs = performance.now() - startMs;
    if (this.moving) this.requestDraw();
  }

  /** Other figures are framed by the preset in force, or from the side. */
  private frameFirst(): void {
    const turned = this.preset === null;
    this.frameView(this.preset ?? 'side');
    if (turned) this.props.onViewChange?.(this.preset);
  }

  private readPoses(): void {
    this.props.performers.forEach(({ source }, i) =>
      source.prefetch(frameOf(this.frames, i), this.direction),
    );
    this.posesStale = !this.scene.showFrame(this.frames);
    if (this.scene.drawable === this.drawable) return;
    this.drawable = this.scene.drawable;
    this.props.onDrawable?.(this.drawable);
  }

  /** On a narrow stage the tools reach over its middle. */
  private get headroom(): number {
    return this.width < NARROW_PX ? Math.min(TOOLS_PX / Math.max(1, this.height), 0.2) : 0;
  }

  private framing(): Framing {
    const aspect = this.width / Math.max(1, this.height);
    return framing(aspect, this.scene.place, this.headroom, this.props.room);
  }

  private moveCamera(nowMs: number): void {
    const passedMs = nowMs - this.drawnMs;
    const stepMs = this.moving ? Math.min(Math.max(passedMs, 0), LONGEST_STEP_MS) : FIRST_STEP_MS;
    this.drawnMs = nowMs;
    const followed = this.props.follow && this.scene.ready ? this.framing() : null;
    this.moving = this.rig.step(stepMs / 1000, !this.props.reducedMotion, followed);
  }
}

/** A click turns the figure and leaves the keyboard where it was; Tab brings it here. */
function keepFocus(event: MouseEvent): void {
  event.preventDefault();
}
