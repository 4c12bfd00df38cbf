// All numbers that the page shows of the keypose that the playhead is on. In: the page; a report of the
// command line. Out: the texts shown, and those to be expected.
import type { Page } from '@playwright/test';
import { decimal, short, signedPercent } from './english';
import type { CandidateReport, KeyposeReport, Report, TraceReport } from './reports';

export interface KeyposeFigures {
  readonly clock: string;
  readonly flag: string;
  readonly playhead: string;
  readonly caption: string;
  readonly card: string;
  readonly pin: string;
  readonly name: string;
  readonly intensity: string;
  readonly strongest: string;
  readonly chart: string;
  readonly parts: readonly string[];
  readonly neighbours: readonly string[];
}

export function shownKeypose(page: Page): Promise<KeyposeFigures> {
  return page.evaluate(() => {
    const plain = (text: string | null | undefined): string =>
      (text ?? '').replace(/\s+/g, ' ').trim();
    const text = (selector: string): string => plain(document.querySelector(selector)?.textContent);
    const attribute = (selector: string, name: string): string =>
      plain(document.querySelector(selector)?.getAttribute(name));
    const all = (selector: string): string[] =>
      [...document.querySelectorAll(selector)].map((found) => plain(found.textContent));
    const why = 'section[aria-label="Why here"]';
    return {
      clock: `${text('.clock-time')} ${text('.clock-frame')}`,
      flag: text('.playhead-flag'),
      playhead: attribute('.playhead', 'aria-valuetext'),
      caption: /^Keypose \d+ of \d+/.exec(text('.stage-caption'))?.[0] ?? '',
      card: attribute('.keypose-card.current', 'aria-label').replace(/^\S+ \S+, /, ''),
      pin: attribute('.pin.current', 'aria-label'),
      name: `${text(`${why} .why-name`)}, ${text(`${why} .why-time`)}`,
      intensity: text(`${why} .beside`),
      strongest: /^Strongest at .* Hz\./.exec(text(`${why} .why-words`))?.[0] ?? '',
      chart: attribute(`${why} .why-chart`, 'aria-label'),
      parts: all(`${why} .parts tr`),
      neighbours: all(`${why} .button-row .button`),
    };
  });
}

const partNames: Readonly<Record<string, string>> = {
  left_arm: 'Left arm',
  right_arm: 'Right arm',
  left_leg: 'Left leg',
  right_leg: 'Right leg',
  head: 'Head',
};

/** Ascending, those without a value last. */
function partRows({ body_part_percents: percents }: KeyposeReport): string[] {
  return Object.entries(percents ?? {})
    .sort(([, a], [, b]) => (a ?? Infinity) - (b ?? Infinity) || 0)
    .map(([part, percent]) => `${partNames[part]} ${signedPercent(percent)}`);
}

function neighbours({ candidates }: Report, { rank }: KeyposeReport): string[] {
  const at = (wanted: number): CandidateReport | undefined =>
    candidates.find((candidate) => candidate.rank === wanted);
  const seconds = (found: CandidateReport | undefined): string =>
    found && found.intensity > 0 ? ` ${decimal(found.time_s, 2)} s` : '';
  return [`Stronger${seconds(at(rank - 1))}`, `Weaker${seconds(at(rank + 1))}`];
}

function chart({ scales_hz: scales, traces }: TraceReport, { frame }: KeyposeReport): string {
  const u = traces.find(({ candidate }) => candidate === frame)?.u ?? [];
  const most = Math.max(...u);
  const hz = (index: number): string => short(scales[index] ?? 0, 2);
  return `Its trace runs from ${hz(0)} to ${hz(u.length - 1)} Hz; u is greatest, ${short(most, 2)}, at ${hz(u.indexOf(most))} Hz.`;
}

export function expectedKeypose(
  report: Report,
  traces: TraceReport,
  index: number,
): KeyposeFigures {
  const keypose = report.keyposes[index];
  if (!keypose) throw new Error(`no keypose ${index}`);
  const { frame, time_s: time, intensity, rank, strongest_hz: strongest } = keypose;
  const name = `Keypose ${index + 1} of ${report.keyposes.length}`;
  const spoken = `${name}, ${decimal(time, 2)} seconds`;
  return {
    clock: `${decimal(time, 3)} frame ${frame} / ${report.frames - 1}`,
    flag: decimal(time, 3),
    playhead: `${decimal(time, 3)} seconds, frame ${frame}`,
    caption: name,
    card: spoken,
    pin: spoken,
    name: `Keypose ${index + 1}, ${decimal(time, 2)} s`,
    intensity: `intensity ${decimal(intensity, 1)}, rank ${rank}`,
    strongest: strongest === null ? '' : `Strongest at ${decimal(strongest, 1)} Hz.`,
    chart: chart(traces, keypose),
    parts: partRows(keypose),
    neighbours: neighbours(report, keypose),
  };
}
