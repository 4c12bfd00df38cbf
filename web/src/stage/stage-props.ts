/** What a stage is told and what it tells. */
import type { Theme } from './palette';
import type { StagePerformer } from './figure-set';
import type { Corners } from './tag-layout';
import type { Look, ViewPreset } from './view';

export type StageFailure = 'no-webgl2' | 'context-lost';

/** The figure at another moment. */
export interface StageGhost {
  /** Under the figure, on the ground; empty for a passing ghost, for which the camera stays. */
  readonly tag: string;
  /** Joints × (x, y, z) of the chosen performer, in file units. */
  readonly pose: Float32Array;
}

/** Where the chosen performer's joints go around the current keypose. */
export interface StageTrails {
  readonly joints: Int32Array;
  /** Frames of the poses, ascending. */
  readonly frames: Int32Array;
  /** Frames × joints of the body × (x, y, z), in file units. */
  readonly poses: Float32Array;
}

/** A place of a figure under the pointer. */
export interface StageHit {
  readonly performer: number;
  readonly joint: number;
  /** Of the pointer, in CSS pixels from the stage's upper left corner. */
  readonly x: number;
  readonly y: number;
}

export interface StageProps {
  readonly performers: readonly StagePerformer[];
  /** Index of the performer whose ghosts and trails are shown. */
  readonly chosen: number;
  readonly ghosts: readonly StageGhost[];
  /** The number on the ground under the chosen performer; null for none. */
  readonly currentTag: string | null;
  readonly trails: StageTrails | null;
  readonly theme: Theme;
  /** A change puts the camera there; null leaves it where the user turned it. */
  readonly view: ViewPreset | null;
  /** Keep the figures in the middle. */
  readonly follow: boolean;
  /** How many times as much is shown as the figures need, so that two stages have one scale; else it goes by the ghosts. */
  readonly room?: number;
  readonly reducedMotion: boolean;
  readonly moreContrast: boolean;
  /** Widths of the words in the lower corners, from which tags stay away. */
  readonly corners: Corners;
  /** Draw nothing at all. */
  readonly off?: boolean;
  /** Name of the stage for a screen reader. */
  readonly label?: string;
  /** Name of a performer for a screen reader. */
  readonly performerName?: (performer: number) => string;
  /** null: the user turned the camera away from the preset. */
  readonly onViewChange?: (view: ViewPreset | null) => void;
  /** The user looks from there now. */
  readonly onLook?: (look: Look) => void;
  readonly onFailure?: (reason: StageFailure) => void;
  /** The lost context is back and the stage draws again. */
  readonly onRecovery?: () => void;
  /** Whether the frame shown has places that can be drawn. */
  readonly onDrawable?: (drawable: boolean) => void;
  readonly onHover?: (hit: StageHit | null) => void;
  readonly onPick?: (hit: StageHit) => void;
  readonly onChoose?: (performer: number) => void;
}

export interface StageMetrics {
  readonly drawCalls: number;
  readonly triangles: number;
  /** Frames drawn since the stage was made. */
  readonly framesDrawn: number;
  /** Time of the last frame's own JavaScript. */
  readonly lastFrameMs: number;
  /** Vectors of four numbers that the hungriest shader takes as uniforms; WebGL 2 guarantees 224. */
  readonly uniformVectors: number;
  /** Fewer pixels and no shade on ghosts, since frames were slow. */
  readonly reduced: boolean;
}
