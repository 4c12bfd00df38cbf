/** The state of the pair page in; its A–B loop over the rows out: moved by its tabs, cleared by Escape or two clicks. */
import type { Context } from '../app/context';
import { follow } from '../common/mount';
import { timelineText } from '../study/study-text';
import type { LoopText } from '../timeline/loop-tabs';
import { rangeOf, setLoop } from './loop-frames';
import { type LoopRanges, PairLoopBand } from './pair-loop-band';
import type { PairState } from './pair-state';
import type { Two, TwoSignal } from './two';

/** Returns what puts its tabs over all that has been mounted since. */
export function showLoop(
  area: HTMLElement,
  context: Context,
  state: PairState,
  two: TwoSignal,
): () => void {
  const { store, language } = context;
  const loopsOf = (shown: Two): LoopRanges | null => {
    const { loop } = state.loop.value;
    const alignment = state.alignment.value;
    return loop && [rangeOf(0, loop, alignment, shown), rangeOf(1, loop, alignment, shown)];
  };
  const view = new PairLoopBand(area, {
    onLoop: (clip, range) => setLoop(state, two.peek(), clip, range),
  });
  follow(() => {
    const shown = two.value;
    if (!shown) return;
    const words = timelineText(language.words.value);
    const { t } = language.words.value;
    const text = (clip: 'A' | 'B'): LoopText => ({
      ...words,
      loopStart: t('pair.loop-start', clip),
      loopEnd: t('pair.loop-end', clip),
    });
    view.update(shown, loopsOf(shown), state.loop.value.looping, [text('A'), text('B')]);
  });
  document.addEventListener('keydown', (event) => {
    const { activeElement } = document;
    const isFree = activeElement === document.body || area.contains(activeElement);
    if (event.key !== 'Escape' || event.defaultPrevented || !isFree) return;
    if (store.compare.page.peek() === 'pair') state.clock.setLoop(null);
  });
  return () => view.raiseTabs();
}
