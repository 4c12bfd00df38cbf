/** The state of the pair page in; its playhead over the rows and its twin under the pointer out. */
import type { Context } from '../app/context';
import { element } from '../common/element';
import { follow } from '../common/mount';
import { PairPlayhead } from './pair-playhead';
import type { PairState } from './pair-state';
import type { TwoSignal } from './two';

export function showPlayhead(
  area: HTMLElement,
  { language }: Context,
  state: PairState,
  two: TwoSignal,
) {
  const playhead = new PairPlayhead(area);
  const slider = element('div', 'pair-slider');
  slider.tabIndex = 0;
  slider.setAttribute('role', 'slider');
  slider.setAttribute('aria-valuemin', '0');
  area.append(slider);
  follow(() => {
    const shown = two.value;
    if (!shown) return;
    const { a, b, axes } = shown;
    const { frames, pairS } = state.moment.value;
    const { t, format } = language.words.value;
    const times = [a, b].map(({ frameTimeS }, i) =>
      format.decimal((frames[i] ?? 0) * frameTimeS, 2),
    );
    const [xA, xB] = [0, 1].map((i) => axes[i].x(frames[i] ?? 0));
    playhead.show(xA, xB, times[0], times[1], axes[0].width);
    slider.style.transform = `translateX(${xA}px)`;
    slider.setAttribute('aria-label', t('timeline.playhead'));
    slider.setAttribute('aria-valuemax', state.alignment.value.durationS.toFixed(3));
    slider.setAttribute('aria-valuenow', pairS.toFixed(3));
    slider.setAttribute('aria-valuetext', t('pair.spoken.times', times[0], times[1]));
  });
  showTwin(playhead, state, two);
}

/** The moment under the pointer, of both. */
function showTwin(playhead: PairPlayhead, state: PairState, two: TwoSignal): void {
  follow(() => {
    const shown = two.value;
    const hovered = state.hovered.value;
    if (!shown || !hovered || hovered.clip > 1) return playhead.showTwin(null);
    const clips = [shown.a, shown.b];
    const alignment = state.alignment.value;
    const at = alignment.pairTimeOf(hovered.clip, hovered.frame * clips[hovered.clip].frameTimeS);
    const x = (i: 0 | 1): number =>
      i === hovered.clip
        ? shown.axes[i].x(hovered.frame)
        : shown.axes[i].x(alignment.timeOf(i, at) / clips[i].frameTimeS);
    playhead.showTwin([x(0), x(1)]);
  });
}
