/** The stage: the only part of the app that knows three.js. */
export { Stage } from './stage';
export type {
  StageFailure,
  StageGhost,
  StageHit,
  StageMetrics,
  StageProps,
  StageTrails,
} from './stage-props';
export type { StagePerformer } from './figure-set';
export type { Theme } from './palette';
export type { Look, Stance, ViewPreset } from './view';
