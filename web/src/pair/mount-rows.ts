/** The state of the pair page in; its rows under the stage out: strips, pins, speeds, ribbon, ahead, differences. */
import { computed, signal } from '@preact/signals-core';
import { html, nothing } from 'lit-html';
import type { Context } from '../app/context';
import { element } from '../common/element';
import { follow, mount } from '../common/mount';
import { watchPixelRatio } from '../timeline/canvas';
import { aheadOutline } from './ahead';
import { differenceShades } from './difference';
import { drawDifference } from './difference-canvas';
import { rangeOf } from './loop-frames';
import { showPins, showStrip } from './mount-clip-rows';
import { showLoop } from './mount-loop';
import { showPlayhead } from './mount-playhead';
import { showSpans } from './mount-spans';
import type { PairClip } from './pair-clips';
import { pairGraph, ribbonTimes, type GraphClip } from './pair-graph';
import type { PairState } from './pair-state';
import { placeAt } from './place-at';
import { keyposeLines, matchingLines } from './ribbon';
import { flagCover, ribbonLabels, ribbonTicks, tabCovers, uncovered } from './ribbon-labels';
import { rowLabels } from './row-labels';
import { alignmentText, speedAt, warpingText } from './row-words';
import { axesOf, rows, ROWS_HEIGHT, type RowPlace } from './rows-layout';
import { listenToRows } from './rows-pointer';
import { speedOutline } from './speed-outline';
import type { Two, TwoSignal } from './two';

export function mountRows(place: HTMLElement, context: Context, state: PairState): void {
  const gutter = element('div', 'row-gutter');
  const area = element('div', 'pair-area');
  area.id = 'pair-area';
  place.append(gutter, area);
  area.style.height = gutter.style.height = `${ROWS_HEIGHT}px`;
  const width = signal(0);
  new ResizeObserver(() => {
    width.value = Math.max(0, area.clientWidth);
  }).observe(area);
  const two = computed((): Two | null => {
    const [a, b] = state.clips.value;
    if (!a || !b || width.value === 0) return null;
    const [axisA, axisB] = axesOf([a, b], width.value, state.rows.span.value);
    return { a, b, axes: [axisA, axisB] };
  });
  follow(() => {
    place.hidden = state.clips.value.length < 2;
  });
  showLabels(gutter, context, state);
  showGraph(area, context, state, two);
  const raiseTabs = showLoop(area, context, state, two);
  showTimes(area, context, state, two);
  showWarping(area, context, state);
  showDifference(area, context, state, two);
  for (const clip of [0, 1] as const) {
    showStrip(area, clip, context, state, two);
    showPins(area, clip, context, state, two);
  }
  showSpans(area, context, state, two);
  showPlayhead(area, context, state, two);
  raiseTabs();
  listenToRows(area, state, two);
}

function showLabels(gutter: HTMLElement, context: Context, state: PairState): void {
  const { store, language } = context;
  mount(gutter, () => {
    const [a, b] = state.clips.value;
    if (!a || !b) return html``;
    const words = language.words.value;
    const { frames } = state.moment.value;
    return rowLabels({
      words,
      a,
      b,
      speeds: [speedAt(a, frames[0] ?? 0), speedAt(b, frames[1] ?? 0)],
      alignment: alignmentText(words, store.compare.synchronisation.value, state),
    });
  });
}

function showGraph(area: HTMLElement, context: Context, state: PairState, two: TwoSignal): void {
  const place = element('div', 'pair-graph-place');
  area.append(place);
  mount(place, () => {
    const shown = two.value;
    if (!shown) return html``;
    const { a, b, axes } = shown;
    const { t, format } = context.language.words.value;
    const warping = state.warping.value;
    const alignment = state.alignment.value;
    const ahead = warping && aheadOutline(warping, axes[1]);
    const [ribbonA, ribbonB] = [
      { ...a, axis: axes[0] },
      { ...b, axis: axes[1] },
    ];
    const [graphA, graphB] = speeds(shown);
    return pairGraph({
      width: axes[0].width,
      a: graphA,
      b: graphB,
      lines: matchingLines(alignment, ribbonA, ribbonB),
      keyposeLines: keyposeLines(alignment, a.keyposes, ribbonA, ribbonB),
      ahead,
      aheadText: [t('pair.ahead.most', format.integer(100 * (ahead?.scale ?? 0))), 'B'],
    });
  });
}

/** The times at the ribbon's edges; those under a flag of the playhead or a tab of the loop give way. */
function showTimes(area: HTMLElement, { language }: Context, state: PairState, two: TwoSignal) {
  const place = element('div', 'pair-graph-place');
  area.append(place);
  const labels = computed(() => {
    const { t } = language.words.value;
    const shown = two.value;
    return [shown?.a, shown?.b].map((clip, i) => {
      if (!shown || !clip) return [];
      const ticks = ribbonTicks(shown.axes[i], clip.frameTimeS);
      return ribbonLabels(ticks, shown.axes[i].width, (seconds) => t('unit.seconds', seconds));
    });
  });
  mount(place, () => {
    const shown = two.value;
    if (!shown) return html``;
    const { frames } = state.moment.value;
    const { loop } = state.loop.value;
    const [a, b] = ([0, 1] as const).map((i) => {
      const axis = shown.axes[i];
      const range = loop && rangeOf(i, loop, state.alignment.value, shown);
      const tabs = range ? tabCovers(axis.x(range.a), axis.x(range.b)) : [];
      return uncovered(labels.value[i], [flagCover(axis.x(frames[i] ?? 0)), ...tabs]);
    });
    return ribbonTimes(shown.axes[0].width, [a, b]);
  });
}

/** Without a path: why, and what can be done. */
function showWarping(area: HTMLElement, { language }: Context, state: PairState): void {
  const place = placeAt(area, 'pair-warping', rows.ahead);
  const { progress, cancelled, cancel, warp } = state.warpings;
  const button = (text: string, onPress: () => void) =>
    html`<button type="button" class="button line" @click=${onPress}>${text}</button>`;
  mount(place, () => {
    const words = language.words.value;
    const text = warpingText(words, state);
    place.hidden = text === '';
    return html`<span>${text}</span>
      ${progress.value === null ? nothing : button(words.t('pair.warp.cancel'), cancel)}
      ${cancelled.value ? button(words.t('pair.warp.again'), warp) : nothing}`;
  });
}

function speeds({ a, b, axes }: Two): readonly [GraphClip, GraphClip] {
  const results = [a.performer.keyposes, b.performer.keyposes];
  const maximum = Math.max(...results.map((result) => result?.maximumSpeed ?? 0));
  const graph = ({ frameTimeS }: PairClip, i: 0 | 1, row: RowPlace): GraphClip => ({
    ticks: ribbonTicks(axes[i], frameTimeS).ticks,
    speed: results[i] && speedOutline(results[i], axes[i], row, maximum),
  });
  return [graph(a, 0, rows.speedA), graph(b, 1, rows.speedB)];
}

function showDifference(area: HTMLElement, context: Context, state: PairState, two: TwoSignal) {
  const canvas = element('canvas', 'pair-difference') as HTMLCanvasElement;
  canvas.style.top = `${rows.parts.top}px`;
  canvas.setAttribute('role', 'img');
  area.append(canvas);
  const pixels = signal(0);
  watchPixelRatio(() => {
    pixels.value++;
  });
  follow(() => {
    const shown = two.value;
    const warping = state.warping.value;
    void [context.theme.theme.value, pixels.value];
    canvas.hidden = !shown || !warping;
    canvas.setAttribute('aria-label', context.language.words.value.t('pair.difference.label'));
    if (!shown || !warping) return;
    drawDifference(canvas, differenceShades(warping, shown.axes[1]), shown.axes[1].width);
  });
}
