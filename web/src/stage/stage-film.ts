/**
 * In: what one stage or several show, a moment after the other. Out: their pictures at a size of their own,
 * on a canvas of their own: nothing of the screen's stages goes in, neither size nor rest nor speed.
 */
import { PerspectiveCamera, WebGLRenderer } from 'three';
import { FilmCamera } from './film-camera';
import { filmTags, type FilmTag } from './film-tags';
import type { StagePerformer } from './figure-set';
import { readPalette, type Theme } from './palette';
import { StageScene } from './stage-scene';
import type { StageGhost, StageTrails } from './stage-props';
import { framing, presetView, type Stance, type ViewPreset } from './view';

export interface FilmPane {
  readonly performers: readonly StagePerformer[];
  /** Index of the performer whose ghosts and trails are shown. */
  readonly chosen: number;
  readonly follow: boolean;
  /** How many times as much is shown as the figures need, here and on the stage of the stance. */
  readonly room: number;
  readonly stageRoom: number;
  /** From where a stage looks; where there is none, by the preset. */
  readonly stance: Stance | null;
  readonly preset: ViewPreset;
}

export interface FilmSize {
  /** Of each pane, in pixels. */
  readonly width: number;
  readonly height: number;
  /** Pixels of one CSS pixel. */
  readonly ratio: number;
}

export interface FilmMoment {
  /** The frame of each performer. */
  readonly frames: readonly number[];
  readonly ghosts: readonly StageGhost[];
  /** The number under the chosen performer; empty for none. */
  readonly currentTag: string;
  readonly trails: StageTrails | null;
  /** Seconds of the film since the pane's last picture. */
  readonly dtS: number;
}

interface Pane extends FilmPane {
  readonly scene: StageScene;
  camera: FilmCamera | null;
  moment: FilmMoment | null;
}

/** null where the browser has no WebGL2. `element`: whose tokens are the colours. */
export function createStageFilm(
  element: Element,
  theme: Theme,
  size: FilmSize,
  panes: readonly FilmPane[],
): StageFilm | null {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('webgl2', {
    antialias: true,
    alpha: false,
    stencil: true,
    // A picture is taken when it is done, a few tasks after it was asked for.
    preserveDrawingBuffer: true,
  });
  if (context === null) return null;
  const renderer = new WebGLRenderer({ canvas, context });
  // The page's stages have tried these shaders; to ask again takes as long as they take to compile.
  renderer.debug.checkShaderErrors = false;
  const palette = readPalette(element, theme);
  const moreContrast = matchMedia('(prefers-contrast: more)').matches;
  const scenes = panes.map((pane): Pane => {
    const scene = new StageScene();
    scene.setPalette(palette);
    scene.setPixelRatio(size.ratio);
    scene.setContrast(moreContrast);
    scene.setPerformers(pane.performers);
    scene.setChosen(pane.chosen);
    return { ...pane, scene, camera: null, moment: null };
  });
  return new StageFilm(renderer, context, size, scenes);
}

export class StageFilm {
  private ended = false;

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly context: WebGL2RenderingContext,
    private readonly size: FilmSize,
    private readonly panes: readonly Pane[],
  ) {
    renderer.setSize(size.width, size.height, false);
  }

  /** Shaders are compiled beside the page, where the browser can; graphics that have gone end the wait. */
  async compiled(): Promise<void> {
    const gone = new Promise<void>((resolve) =>
      this.renderer.domElement.addEventListener('webglcontextlost', () => resolve(), {
        once: true,
      }),
    );
    await Promise.race([gone, this.compile()]);
  }

  /** Draws a pane's next picture, whose poses must be there; null where they are not or the graphics have gone. */
  async draw(index: number, moment: FilmMoment): Promise<HTMLCanvasElement | null> {
    const pane = this.panes[index];
    const { scene } = pane;
    if (moment.ghosts !== pane.moment?.ghosts) scene.setGhosts(moment.ghosts);
    if (moment.trails !== pane.moment?.trails) scene.setTrails(moment.trails);
    if (this.ended || !scene.showFrame(moment.frames) || this.context.isContextLost()) return null;
    pane.moment = moment;
    pane.camera ??= this.cameraOf(pane);
    pane.camera.step(this.framed(pane), moment.dtS);
    scene.setGridCentre(pane.camera.targetX, pane.camera.targetZ);
    scene.setEye(pane.camera.camera.position);
    this.renderer.render(scene.scene, pane.camera.camera);
    await allDrawn(this.context);
    return this.context.isContextLost() ? null : this.renderer.domElement;
  }

  /** Of the picture drawn last, in CSS pixels. */
  tags(index: number): FilmTag[] {
    const { scene, camera, moment } = this.panes[index];
    if (!camera || !moment) return [];
    const { width, height, ratio } = this.size;
    const area = { width: width / ratio, height: height / ratio, left: 0, right: 0 };
    const numbers = { current: moment.currentTag, ghosts: moment.ghosts.map(({ tag }) => tag) };
    return filmTags(scene, numbers, camera.camera, area);
  }

  /** Gives the graphics back, once they have done what they are about: that would hold up the page. */
  async destroy(): Promise<void> {
    this.ended = true;
    await allDrawn(this.context);
    this.renderer.forceContextLoss();
    for (const { scene } of this.panes) scene.dispose();
    this.renderer.dispose();
  }

  private async compile(): Promise<void> {
    const camera = new PerspectiveCamera();
    for (const { scene } of this.panes) await this.renderer.compileAsync(scene.scene, camera);
  }

  private get aspect(): number {
    return this.size.width / this.size.height;
  }

  private framed({ scene, room, stageRoom, stance }: Pane) {
    const here = framing(this.aspect, scene.place, 0, room);
    const onStage = framing(stance?.aspect ?? this.aspect, scene.place, 0, stageRoom);
    return { here, onStage };
  }

  private cameraOf(pane: Pane): FilmCamera {
    const { scene, performers, room, preset } = pane;
    const plain = (): Stance => {
      const view = presetView(preset, performers[0], this.aspect, scene.place, 0, room);
      const { yawRad, elevationRad } = view;
      const nowhere = { zoom: 1, offsetX: 0, offsetY: 0, offsetZ: 0 };
      return { framed: view, aspect: this.aspect, yawRad, elevationRad, ...nowhere };
    };
    return new FilmCamera(pane.stance ?? plain(), pane.follow, this.aspect);
  }
}

const LOOK_AGAIN_MS = 2;

/**
 * Until the graphics have drawn what they were asked for: who took the picture before would stand still for as
 * long. A hidden page has nobody who waits, and its timers are slow.
 */
async function allDrawn(context: WebGL2RenderingContext): Promise<void> {
  const fence = context.fenceSync(context.SYNC_GPU_COMMANDS_COMPLETE, 0);
  context.flush();
  const isDrawn = (): boolean =>
    fence === null ||
    document.hidden ||
    context.isContextLost() ||
    context.getSyncParameter(fence, context.SYNC_STATUS) === context.SIGNALED;
  while (!isDrawn()) await new Promise((resolve) => setTimeout(resolve, LOOK_AGAIN_MS));
  context.deleteSync(fence);
}
