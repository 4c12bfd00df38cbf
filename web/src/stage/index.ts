/** The stage: the only part of the app that knows three.js. */
export { Stage } from './stage';
export type { StageFailure, StageMetrics, StageProps } from './stage-props';
export type { StagePerformer } from './stage-scene';
export type { Theme } from './palette';
export type { ViewPreset } from './view';
