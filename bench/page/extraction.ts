/** Extraction: a read clip goes in, the time from its channels to its keyposes comes out. */
import type { CoreClip } from '../../web/src/engine/raw';

export interface Extracted {
  readonly analyseMs: number;
  /** The longest time without a look at messages. */
  readonly longestStepMs: number;
  readonly frames: number;
  readonly keyposes: number;
}

/** Analyses the clip afresh, whatever was known of it. */
export function extract(clip: CoreClip): Extracted {
  const start = performance.now();
  let longestStepMs = 0;
  clip.beginAnalysis({}, {});
  for (let done = 0, at = start; done < 1;) {
    done = clip.step();
    const now = performance.now();
    longestStepMs = Math.max(longestStepMs, now - at);
    at = now;
  }
  const analyseMs = performance.now() - start;
  const { frames, performers } = clip.result();
  const keyposes = performers[0]?.keyposes?.keyposes.length ?? 0;
  return { analyseMs, longestStepMs, frames, keyposes };
}
