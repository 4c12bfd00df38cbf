/** The pair's A–B loop in; its ends in frames of a clip out, and back. */
import type { LoopRange } from '../player/clock';
import type { Alignment } from './alignment';
import type { PairLoop } from './pair-clock';
import type { PairState } from './pair-state';
import type { Two } from './two';

/** Ends nearer than this are one, in frames. */
const SAME = 1e-6;

/** A loop in frames of a clip, whole or not. */
export function rangeOf(
  clip: 0 | 1,
  { fromS, toS }: PairLoop,
  alignment: Alignment,
  two: Two,
): LoopRange {
  const { frameTimeS } = [two.a, two.b][clip];
  const frame = (pairS: number): number => alignment.timeOf(clip, pairS) / frameTimeS;
  return { a: frame(fromS), b: frame(toS) };
}

/** Seconds of A between which it loops; where A stands still all the while, of B. */
export function loopTimes({ fromS, toS }: PairLoop, alignment: Alignment): [number, number] {
  const ofClip = (clip: 0 | 1): [number, number] => [
    alignment.timeOf(clip, fromS),
    alignment.timeOf(clip, toS),
  ];
  const [a, b] = ofClip(0);
  return b > a ? [a, b] : ofClip(1);
}

/** An end that has not moved keeps its moment: a clip may stand still there. */
export function setLoop(state: PairState, two: Two | null, clip: 0 | 1, { a, b }: LoopRange): void {
  if (!two) return;
  const { frameTimeS } = [two.a, two.b][clip];
  const { loop } = state.loop.peek();
  const was = loop && rangeOf(clip, loop, state.alignment.peek(), two);
  const momentOf = (frame: number): number => {
    if (loop && was && Math.abs(frame - was.a) < SAME) return loop.fromS;
    if (loop && was && Math.abs(frame - was.b) < SAME) return loop.toS;
    return state.alignment.peek().pairTimeOf(clip, frame * frameTimeS);
  };
  state.clock.setLoop({ fromS: momentOf(a), toS: momentOf(b) });
}

/** Whether a place of a clip, in frames, lies in the loop. */
export function isInLoop(state: PairState, two: Two, clip: 0 | 1, frame: number): boolean {
  const { loop } = state.loop.peek();
  const range = loop && rangeOf(clip, loop, state.alignment.peek(), two);
  return range !== null && frame >= range.a && frame <= range.b;
}
