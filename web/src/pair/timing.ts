/** A clip's speed and keyposes in; the figures of its timing out. Pure. */
import type { KeyposeResult } from '../engine/types';

export interface Timing {
  readonly keyposes: number;
  /** Mean time from keypose to keypose; null with fewer than two. */
  readonly betweenS: number | null;
  /** Mean of the motion speed in body heights per second; null where there is none. */
  readonly meanSpeed: number | null;
}

export function timingOf(
  keyposes: Int32Array,
  result: Pick<KeyposeResult, 'speed'> | null,
  frameTimeS: number,
): Timing {
  const steps = keyposes.length - 1;
  const spanS = steps > 0 ? (keyposes[steps] - keyposes[0]) * frameTimeS : 0;
  const speed = result?.speed ?? new Float64Array();
  const sum = speed.reduce((a, b) => a + b, 0);
  return {
    keyposes: keyposes.length,
    betweenS: steps > 0 ? spanS / steps : null,
    meanSpeed: speed.length > 0 ? sum / speed.length : null,
  };
}

/** What the sentence says: whose keyposes come faster, and how many times. */
export type Tempo =
  | { readonly kind: 'unknown' | 'same' }
  | { readonly kind: 'faster'; readonly who: 'a' | 'b'; readonly times: number };

/** Below this ratio nobody would call one the faster. */
const SAME_TEMPO = 1.05;

export function tempoOf(a: Timing, b: Timing): Tempo {
  if (!a.betweenS || !b.betweenS) return { kind: 'unknown' };
  const ratio = b.betweenS / a.betweenS;
  const times = Math.max(ratio, 1 / ratio);
  if (times < SAME_TEMPO) return { kind: 'same' };
  return { kind: 'faster', who: ratio > 1 ? 'a' : 'b', times };
}
