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
}

export interface Caption {
  readonly title: string;
  /** "0.06 s past it"; empty at the keypose itself. */
  readonly remark: string;
  readonly spoken: string;
}

export function captionOf({ t, format }: Words, moment: Moment): Caption {
  const { current, keyposes, frame, frameTimeS } = moment;
  const rest = frame < moment.leadingRestFrames ? t('caption.rest') : '';
  if (current === null)
    return { title: t('caption.none'), remark: rest, spoken: rest || t('caption.none') };
  const at = keyposes[current] ?? 0;
  const count = format.integer(keyposes.length);
  const number = format.integer(current + 1);
  const title = t('caption.keypose', number, count);
  const spoken = t('spoken.keypose', number, count, format.decimal(at * frameTimeS, 2));
  if (frame === at) return { title, remark: '', spoken };
  const away = format.decimal(Math.abs(frame - at) * frameTimeS, 2);
  const side = frame > at ? 'past' : 'before';
  return {
    title,
    remark: rest || t(`caption.${side}`, away),
    spoken: t(`spoken.${side}`, spoken, away),
  };
}
