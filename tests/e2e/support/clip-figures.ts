// Numbers that the page shows of a whole clip beside the timeline. In: the page; a report of the command
// line. Out: the texts shown, and those to be expected.
import type { Page } from '@playwright/test';
import { decimal, figure, short } from './english';
import type { Report } from './reports';

export interface ClipFigures {
  readonly row: string;
  readonly keyposes: string;
  readonly strip: string;
  readonly last: string;
  readonly cut: string;
  readonly maximum: string;
  readonly summaries: readonly string[];
}

export function shownClip(page: Page): Promise<ClipFigures> {
  return page.evaluate(() => {
    const text = (element: Element | null | undefined): string =>
      (element?.textContent ?? '').replace(/\s+/g, ' ').trim();
    const find = (selector: string): string => text(document.querySelector(selector));
    const figures = [...document.querySelectorAll('.row-figure')].map(text);
    const summaries = [...document.querySelectorAll('.row-summary')];
    return {
      row: find('.clip.open .clip-facts'),
      keyposes: find('.clip.open .clip-counts .count').replace(/^\S+ /, ''),
      strip: find('.strip-count'),
      last: find('.clock-last'),
      cut: figures[2] ?? '',
      maximum: find('.row-end:not([hidden])'),
      summaries: summaries.map((summary) => summary.getAttribute('aria-label') ?? ''),
    };
  });
}

export function expectedClip(report: Report): ClipFigures {
  const { scale_max_hz: finest, scale_min_hz: coarsest } = report.parameters;
  const { keyposes, candidates, cut, maximum_speed: maximum, frame_rate_hz: rate } = report;
  const last = report.frames - 1;
  const lengthS = last * report.frame_time_s;
  const above = cut === null ? '' : decimal(cut, 1);
  return {
    row: `${decimal(lengthS, 1)} s · ${short(rate, 2)} Hz`,
    keyposes: `${keyposes.length} keyposes`,
    strip: String(keyposes.length),
    last: `/ ${last}`,
    cut: cut === null ? '' : figure(cut),
    maximum: figure(maximum),
    summaries: [
      `Motion speed, at most ${decimal(maximum, 1)} body heights a second`,
      `Time scales from ${short(finest, 2)} to ${short(coarsest, 2)} hertz: traces of ${keyposes.length} keyposes among ${candidates.length} candidates`,
      `Intensity: ${keyposes.length} of ${candidates.length} candidates lie above the cut at ${above}`,
    ],
  };
}
