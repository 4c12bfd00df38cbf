/** Timeline of the open clip on the page: there while a clip with a motion is open. */
import { computed } from '@preact/signals-core';
import type { Context } from '../app/context';
import { keep } from '../common/keep';
import { follow } from '../common/mount';
import type { Words } from '../app/i18n/catalogue';
import type { Store } from '../app/store';
import type { PerformerResult } from '../engine/types';
import type { ScaleRange } from '../timeline/scale-axis';
import { Timeline, type TimelineEvents, type TimelineProps } from '../timeline/timeline';
import { rememberFolds } from './folds';
import { followPlayhead } from './follow-playhead';
import { timelineText } from './study-text';

export function mountTimeline(place: HTMLElement, context: Context): void {
  const { store, language } = context;
  const text = computed(() => timelineText(language.words.value));
  const range = computed(() => scaleRange(store));
  const events = timelineEvents(context);
  const show = keep<TimelineProps>((props) => new Timeline(place, props, events));
  rememberFolds(context.store, context.preferences, window.innerHeight);
  followPlayhead(store);
  follow(() => show(timelineProps(context, text.value, range.value)));
}

/** A body at rest has a speed of zero, and nothing that the rows could show. */
const moves = ({ keyposes }: PerformerResult): boolean => (keyposes?.maximumSpeed ?? 0) > 0;

/** Why there are no rows to show. */
function reasonOf(performer: PerformerResult, { t, failure }: Words): string {
  if (performer.unanalysed) return failure(performer.unanalysed);
  return moves(performer) ? '' : t('timeline.still');
}

/** The range of the parameters as they are set. */
function scaleRange({ defaults, options }: Store): ScaleRange | null {
  if (defaults.value === null) return null;
  const { scaleMaxHz, scaleMinHz } = { ...defaults.value, ...options.value };
  return { finestHz: scaleMaxHz, coarsestHz: scaleMinHz };
}

function timelineEvents({ store, playback }: Context): TimelineEvents {
  return {
    onSeek: (frame) => playback.seek(frame),
    onHover: (frame) => {
      store.hoverFrame.value = frame;
    },
    onZoom: (span) => {
      store.zoom.value = span;
    },
    onFold: (row, folded) => {
      const rows = new Set(store.folded.peek());
      if (folded) rows.add(row);
      else rows.delete(row);
      store.folded.value = rows;
    },
    onLoop: (range) => playback.setLoop(range),
  };
}

function timelineProps(
  { store, language, theme }: Context,
  text: TimelineProps['text'],
  scaleRange: ScaleRange | null,
): TimelineProps | null {
  const clip = store.openClip.value;
  const performer = store.openPerformer.value;
  if (!clip?.result || !performer) return null;
  const { frame, loop, looping } = store.playback.value;
  return {
    frames: clip.result.frames,
    frameTimeS: clip.result.frameTimeS,
    leadingRestFrames: performer.leadingRestFrames,
    keyposes: moves(performer) ? performer.keyposes : null,
    scaleRange,
    reason: reasonOf(performer, language.words.value),
    outdated: clip.outdated,
    currentKeypose: store.currentKeypose.value,
    frame,
    hoverFrame: store.hoverFrame.value,
    span: store.span.value,
    folded: store.folded.value,
    loop,
    looping,
    theme: theme.theme.value,
    text,
  };
}
