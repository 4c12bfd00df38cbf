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
    timeline: t('timeline.label'),
    pins: t('timeline.pins'),
    time: t('timeline.time'),
    timeUnits: t('timeline.time-units'),
    speed: t('timeline.speed'),
    speedUnit: t('timeline.speed-unit'),
    playhead: t('timeline.playhead'),
    seconds: (timeS, digits) => format.decimal(timeS, digits),
    // Frames are labels, not quantities: without marks between thousands.
    count: (value) => String(value),
    speedValue: (value) => format.decimal(value, value < 10 ? 1 : 0),
    keypose: keyposeText(words),
    keyposes: (first, last, count) =>
      t('spoken.keyposes', format.integer(first), format.integer(last), format.integer(count)),
    moment: (frame, timeS) => t('spoken.moment', format.decimal(timeS, 3), String(frame)),
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
