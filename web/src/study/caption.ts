/** The keypose nearest to the playhead and how far it is in; what the stage says of it, written and spoken, out. */
import type { Words } from '../app/i18n/catalogue';

export interface Moment {
  readonly frame: number;
  readonly frameTimeS: number;
  /** Frames of the keyposes. */
  readonly keyposes: Int32Array;
  /** Index of the nearest keypose. */
  readonly current: number | null;
  readonly leadingRestFrames: number;
  /** What the current keypose looks like, in words; empty if not known. */
  readonly posture: string;
  /** The performer's letter, where there are several. */
  readonly performer: string | null;
}

export interface Caption {
  readonly title: string;
  /** "both legs high"; may be empty. */
  readonly posture: string;
  /** "0.06 s past it"; empty at the keypose itself. */
  readonly remark: string;
  readonly spoken: string;
}

export function captionOf(words: Words, moment: Moment): Caption {
  const caption = captionOfOne(words, moment);
  const { performer } = moment;
  if (performer === null) return caption;
  return {
    ...caption,
    title: words.t('caption.performer', performer, caption.title),
    spoken: words.t('spoken.performer', performer, caption.spoken),
  };
}

function captionOfOne({ t, format }: Words, moment: Moment): Caption {
  const { current, keyposes, frame, frameTimeS, posture } = moment;
  const rest = frame < moment.leadingRestFrames ? t('caption.rest') : '';
  const none = t('caption.none');
  if (current === null) return { title: none, posture: '', remark: rest, spoken: rest || none };
  const at = keyposes[current] ?? 0;
  const count = format.integer(keyposes.length);
  const number = format.integer(current + 1);
  const title = t('caption.keypose', number, count);
  const keypose = t('spoken.keypose', number, count, format.decimal(at * frameTimeS, 2));
  const spoken = posture === '' ? keypose : t('spoken.posture', keypose, posture);
  if (frame === at) return { title, posture, remark: '', spoken };
  const away = format.decimal(Math.abs(frame - at) * frameTimeS, 2);
  const side = frame > at ? 'past' : 'before';
  return {
    title,
    posture: rest ? '' : posture,
    remark: rest || t(`caption.${side}`, away),
    spoken: t(`spoken.${side}`, spoken, away),
  };
}
