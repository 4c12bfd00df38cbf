/** One frame of the stage: a clip and a number of figures go in, its JavaScript and what it draws come out. */
import type { PoseSource } from '../../web/src/engine/pose-source';
import { createBrowserEngine } from '../../web/src/engine/browser-engine';
import { Stage, type StagePerformer, type StageProps } from '../../web/src/stage';
import { fileNamed } from './files';
import { drawNothing } from './watch-frames';

export interface StageFrames {
  readonly figures: number;
  readonly frameMs: number[];
  readonly drawCalls: number;
  readonly triangles: number;
  readonly uniformVectors: number;
}

/** Frames drawn before the clock counts, and with it. */
const WARM_UP = 60;
const FRAMES = 300;

function sourceOf(poses: Float32Array, jointCount: number, frames: number): PoseSource {
  const width = 3 * jointCount;
  const views = Array.from({ length: frames }, (_, frame) =>
    poses.subarray(frame * width, (frame + 1) * width),
  );
  return {
    jointCount,
    frames,
    read: (frame) => views[frame] ?? null,
    prefetch: () => undefined,
    onArrive: () => () => undefined,
    destroy: () => undefined,
  };
}

async function performerOf(name: string): Promise<StagePerformer> {
  const engine = createBrowserEngine('?workers=1');
  const { performers } = await engine.open(1, { name, folder: '', blob: fileNamed(name) }, {}, {});
  const [performer] = performers;
  const poses = await engine.poseRange(1, 0, 0, WARM_UP + FRAMES);
  engine.destroy();
  const joints = performer.skeleton.parents.length;
  return { ...performer, source: sourceOf(poses, joints, WARM_UP + FRAMES) };
}

function propsOf(performers: readonly StagePerformer[]): StageProps {
  return {
    performers,
    chosen: 0,
    ghosts: [],
    currentTag: null,
    trails: null,
    theme: 'light',
    view: 'side',
    follow: true,
    reducedMotion: true,
    moreContrast: false,
    corners: { left: 0, right: 0 },
  };
}

/** Two frames of the browser: the stage has been told its size. */
function settled(): Promise<void> {
  return new Promise((resolve) =>
    requestAnimationFrame(() => requestAnimationFrame(() => resolve())),
  );
}

async function drawAll(
  target: HTMLElement,
  performer: StagePerformer,
  figures: number,
): Promise<StageFrames> {
  const stage = new Stage(target, propsOf(Array.from({ length: figures }, () => performer)));
  await settled();
  const frameMs: number[] = [];
  for (let frame = 0; frame < WARM_UP + FRAMES; frame += 1) {
    const start = performance.now();
    stage.drawFrame(frame);
    if (frame >= WARM_UP) frameMs.push(performance.now() - start);
  }
  const { drawCalls, triangles, uniformVectors } = stage.metrics();
  stage.destroy();
  return { figures, frameMs, drawCalls, triangles, uniformVectors };
}

/** Plays a clip with each number of figures on the stage, of 1000 × 700 pixels. */
export async function drawFrames(
  name: string,
  counts: readonly number[],
): Promise<readonly StageFrames[]> {
  drawNothing();
  const performer = await performerOf(name);
  const target = document.createElement('div');
  target.style.cssText = 'width: 1000px; height: 700px';
  document.body.append(target);
  const found: StageFrames[] = [];
  for (const figures of counts) found.push(await drawAll(target, performer, figures));
  target.remove();
  return found;
}
