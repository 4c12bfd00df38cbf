/** Timing: work goes in, milliseconds of each of several runs come out. */

/** Short work is repeated within a run until the run takes this long, in ms. */
const SHORTEST_RUN_MS = 40;

/** Every work is called for this long, in ms, before the clock counts: the browser compiles what is called often. */
const WARM_UP_MS = 300;

/** No further run begins after those before have taken this long together, in ms. */
const LONGEST_MS = 8_000;

export type Work = () => unknown;

function time(work: Work, repeats: number): number {
  const start = performance.now();
  for (let count = 0; count < repeats; count += 1) work();
  return (performance.now() - start) / repeats;
}

/** Milliseconds of the last call of a warm-up. */
function warmUp(work: Work): number {
  const end = performance.now() + WARM_UP_MS;
  for (;;) {
    const last = time(work, 1);
    if (performance.now() >= end) return last;
  }
}

/** Lets the browser draw and collect between two runs. */
const pause = () => new Promise((resolve) => setTimeout(resolve, 10));

/**
 * Milliseconds of every work in every run. The works take turns within a run, so that what else the
 * machine does falls on all alike. The warm-up of each is not counted, unless its only call took so
 * long that no other follows.
 */
export async function timeInTurn(works: readonly Work[], runs: number): Promise<number[][]> {
  const first = works.map(warmUp);
  const times = first.map((ms) => (ms > LONGEST_MS / 2 ? [ms] : []));
  const end = performance.now() + LONGEST_MS;
  for (let run = 0; run < runs && (run === 0 || performance.now() < end); run += 1) {
    for (const [index, work] of works.entries()) {
      const once = first[index] ?? 0;
      if (once > LONGEST_MS / 2) continue;
      await pause();
      times[index]?.push(time(work, Math.ceil(SHORTEST_RUN_MS / Math.max(once, 0.01))));
    }
  }
  return times;
}
