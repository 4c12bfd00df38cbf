/** The state of the pair page in; while its rows are zoomed, a bar at each strip that shows of which part, out. */
import type { Context } from '../app/context';
import { follow } from '../common/mount';
import { timelineText } from '../study/study-text';
import type { PairState } from './pair-state';
import { axesOf, rows } from './rows-layout';
import { SpanBar } from './span-bar';
import type { TwoSignal } from './two';

const HEIGHT = 10;

export function showSpans(
  area: HTMLElement,
  { language }: Context,
  state: PairState,
  two: TwoSignal,
): void {
  const { stripA, stripB } = rows;
  const tops = [stripA.top, stripB.top + stripB.height - HEIGHT];
  for (const clip of [0, 1] as const) {
    const bar = new SpanBar({
      onPan: (frames) => {
        state.rows.pan(clip, frames * (state.clips.peek()[clip]?.frameTimeS ?? 0));
      },
    });
    bar.element.classList.add('ab'[clip]);
    bar.element.setAttribute('aria-controls', area.id);
    bar.element.style.top = `${tops[clip]}px`;
    area.append(bar.element);
    follow(() => {
      const shown = two.value;
      bar.element.hidden = !shown || state.rows.span.value === null;
      if (!shown) return;
      const words = language.words.value;
      const { a, b, axes } = shown;
      const { frameTimeS } = [a, b][clip];
      const whole = axesOf([a, b], axes[clip].width)[clip];
      const { first, last } = axes[clip].span;
      bar.update({
        shown: axes[clip],
        whole,
        label: words.t('pair.span', 'AB'[clip]),
        text: timelineText(words).shown(
          first * frameTimeS,
          last * frameTimeS,
          whole.span.last * frameTimeS,
        ),
      });
    });
  }
}
