/** Timing: work goes in, milliseconds of each of several runs come out. */

/** Short work is repeated within a run until the run takes this long, in ms. */
const SHORTEST_RUN_MS = 40;

/** No further run begins after those before have taken this long together, in ms. */
const LONGEST_MS = 8_000;

export type Work = () => unknown;

function time(work: Work, repeats: number): number {
  const start = performance.now();
  for (let count = 0; count < repeats; count += 1) work();
  return (performance.now() - start) / repeats;
}

/** Lets the browser draw and collect between two runs. */
const pause = () => new Promise((resolve) => setTimeout(resolve, 10));

/**
 * Milliseconds of every work in every run. The works take turns within a run, so that what else the
 * machine does falls on all alike. The first call of each is the warm-up and not counted, unless it
 * took so long that it is the only one.
 */
export async function timeInTurn(works: readonly Work[], runs: number): Promise<number[][]> {
  const first = works.map((work) => time(work, 1));
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
