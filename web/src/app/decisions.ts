/** One decision about a clip as a change that can be undone; what is absent is automatic. */
import type { ClipId, Decisions, JointDecision } from '../engine/types';
import type { MessageKey } from './i18n/catalogue';

export type DecisionKey = keyof Decisions;

/** What the history calls it. */
export const decisionLabels: Readonly<Record<DecisionKey, MessageKey>> = {
  frameRateHz: 'change.frame-rate',
  leadingRestFrames: 'change.leading-rest',
  up: 'change.up',
  unit: 'change.unit',
  groundHeight: 'change.ground',
  joints: 'change.joints',
};

export interface DecisionChange {
  readonly id: ClipId;
  readonly key: DecisionKey;
  /** undefined: back to automatic. */
  readonly value: Decisions[DecisionKey] | undefined;
}

/** The joints that a person named in one clip; none: all as found. */
export interface JointsChange {
  readonly id: ClipId;
  readonly joints: readonly JointDecision[];
}

export function withDecision(
  decisions: Decisions,
  { key, value }: Omit<DecisionChange, 'id'>,
): Decisions {
  const rest = Object.fromEntries(Object.entries(decisions).filter(([known]) => known !== key));
  return value === undefined ? rest : { ...rest, [key]: value };
}
