/** What a stage is told and what it tells. */
import type { Theme } from './palette';
import type { StagePerformer } from './stage-scene';
import type { ViewPreset } from './view';

export type StageFailure = 'no-webgl2' | 'context-lost';

export interface StageProps {
  readonly performers: readonly StagePerformer[];
  readonly theme: Theme;
  /** A change puts the camera there; null leaves it where the user turned it. */
  readonly view: ViewPreset | null;
  /** Keep the figures in the middle. */
  readonly follow: boolean;
  readonly reducedMotion: boolean;
  /** Draw nothing at all. */
  readonly off?: boolean;
  /** Name of the stage for a screen reader. */
  readonly label?: string;
  /** null: the user turned the camera away from the preset. */
  readonly onViewChange?: (view: ViewPreset | null) => void;
  readonly onFailure?: (reason: StageFailure) => void;
  /** The lost context is back and the stage draws again. */
  readonly onRecovery?: () => void;
}

export interface StageMetrics {
  readonly drawCalls: number;
  readonly triangles: number;
  /** Frames drawn since the stage was made. */
  readonly framesDrawn: number;
  /** Time of the last frame's own JavaScript. */
  readonly lastFrameMs: number;
}
