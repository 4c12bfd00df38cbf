/** The words of a language in; the sentences that timeline and strip ask for out. */
import type { Words } from '../app/i18n/catalogue';
import type { StripText } from '../strip/keypose-strip';
import type { TimelineText } from '../timeline/timeline-text';

/** Seconds as spoken and as written on cards. */
const secondDigits = 2;

export function keyposeText({
  t,
  format,
}: Words): (number: number, count: number, timeS: number) => string {
  return (number, count, timeS) =>
    t(
      'spoken.keypose',
      format.integer(number),
      format.integer(count),
      format.decimal(timeS, secondDigits),
    );
}

export function timelineText(words: Words): TimelineText {
  const { t, format } = words;
  return {
    ...timelineNames(words),
    ...timelineSummaries(words),
    seconds: (timeS, digits) => format.decimal(timeS, digits),
    withUnit: (seconds) => t('unit.seconds', seconds),
    hertz: (value) => t('unit.hertz', format.short(value, 2)),
    short: (value) => format.short(value, 2),
    // Frames are labels, not quantities: without marks between thousands.
    count: (value) => String(value),
    figure: (value) => format.decimal(value, value < 10 ? 1 : 0),
    keypose: keyposeText(words),
    keyposes: (first, last, count) =>
      t('timeline.lozenge', format.integer(first), format.integer(last), format.integer(count)),
    moment: (frame, timeS) => t('spoken.moment', format.decimal(timeS, 3), String(frame)),
    shown: (firstS, lastS, lengthS) =>
      t('timeline.shown', ...[firstS, lastS, lengthS].map((value) => format.decimal(value, 1))),
  };
}

type TimelineNames = {
  [Key in keyof TimelineText]: TimelineText[Key] extends string ? Key : never;
}[keyof TimelineText];

function timelineNames({ t }: Words): Pick<TimelineText, TimelineNames> {
  return {
    timeline: t('timeline.label'),
    pins: t('timeline.pins'),
    time: t('timeline.time'),
    timeUnits: t('timeline.time-units'),
    speed: t('timeline.speed'),
    speedUnit: t('timeline.speed-unit'),
    scales: t('timeline.scales'),
    fine: t('timeline.fine'),
    coarse: t('timeline.coarse'),
    intensity: t('timeline.intensity'),
    cutNote: t('timeline.cut'),
    automatic: t('timeline.automatic'),
    overview: t('timeline.overview'),
    playhead: t('timeline.playhead'),
    loopStart: t('timeline.loop-start'),
    loopEnd: t('timeline.loop-end'),
    loopTip: t('timeline.loop-tip'),
  };
}

function timelineSummaries({
  t,
  format,
}: Words): Pick<TimelineText, 'speedSummary' | 'scalesSummary' | 'intensitySummary'> {
  const { integer, short, decimal } = format;
  return {
    speedSummary: (maximum) => t('timeline.speed.spoken', decimal(maximum, 1)),
    scalesSummary: (finestHz, coarsestHz, keyposes, candidates) =>
      t(
        'timeline.scales.spoken',
        short(finestHz, 2),
        short(coarsestHz, 2),
        integer(keyposes),
        integer(candidates),
      ),
    intensitySummary: (candidates, keyposes, cut) =>
      cut === null
        ? t('timeline.intensity.spoken.none', integer(candidates))
        : t('timeline.intensity.spoken', integer(keyposes), integer(candidates), decimal(cut, 1)),
  };
}

export function stripText(words: Words): StripText {
  const { t, format } = words;
  return {
    strip: t('strip.label'),
    keyposes: t('strip.label'),
    none: t('caption.none'),
    count: (value) => format.integer(value),
    number: (value) => String(value),
    seconds: (timeS, digits) => timeS.toFixed(digits),
    shown: (shown, all) => t('strip.shown', format.integer(shown), format.integer(all)),
    keypose: keyposeText(words),
  };
}
