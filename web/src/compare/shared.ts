/** What the views of the page Compare read together: the scene, the selection, what is hovered. */
import { computed, effect, type ReadonlySignal } from '@preact/signals-core';
import type { Context } from '../app/context';
import type { ClipPair } from '../app/compare-store';
import type { Labels } from '../app/labels';
import type { ClipId } from '../engine/types';
import { clipNames } from './clip-words';
import { comparePalette, type ComparePalette } from './compare-palette';
import { HoverFacts } from './hover-facts';
import { arrivedSince, type Arrived } from './map-arrivals';
import { PictureSource } from './picture-source';
import { sceneOf, type Scene } from './scene';

/** Items of a scene; null: not in it. */
export interface ItemPair {
  readonly a: number | null;
  readonly b: number | null;
}

export interface Shared {
  readonly context: Context;
  /** null until something has been compared; the latest whose picture is there. */
  readonly scene: ReadonlySignal<Scene | null>;
  /** Clips on the map that the scene does not have yet. */
  readonly arrived: ReadonlySignal<readonly Arrived[]>;
  readonly pictures: PictureSource;
  readonly facts: HoverFacts;
  readonly palette: ReadonlySignal<ComparePalette>;
  readonly selected: ReadonlySignal<ItemPair>;
  /** One clip alone is hovered as a pair with itself. */
  readonly hovered: ReadonlySignal<ItemPair | null>;
}

const noneArrived: readonly Arrived[] = [];

function arrivedIn(
  scene: ReadonlySignal<Scene | null>,
  { store }: Context,
): ReadonlySignal<readonly Arrived[]> {
  return computed(() => {
    const [shown, arrivals] = [scene.value, store.compare.arrivals.value];
    if (!shown || arrivals.size === 0) return noneArrived;
    const named = clipNames(store.qualifiers.peek());
    const nameOf = (id: ClipId): string => named(store.clips.peek()[id]);
    const arrived = arrivedSince(shown, arrivals, nameOf, store.labels.value);
    return arrived.length > 0 ? arrived : noneArrived;
  });
}

interface Labelling {
  readonly labels: Labels;
  readonly labelNames: readonly string[];
}

/** Labels of the clips compared: those that only come while others load say nothing new of the set. */
function labellingOf({ store }: Context): ReadonlySignal<Labelling> {
  let before: Labelling = { labels: new Map(), labelNames: [] };
  return computed(() => {
    const clips = store.compare.comparison.value?.clips ?? [];
    const now = { labels: store.labels.value, labelNames: store.labelNames.value };
    const isSame =
      isSameList(before.labelNames, now.labelNames) &&
      clips.every((clip) => before.labels.get(clip) === now.labels.get(clip));
    return isSame ? before : (before = now);
  });
}

const isSameList = (a: readonly string[], b: readonly string[]): boolean =>
  a.length === b.length && a.every((one, k) => one === b[k]);

/** The scene of the newest comparison. */
function latestScene(context: Context): ReadonlySignal<Scene | null> {
  const { store } = context;
  const { comparison, cut, order } = store.compare;
  const labelling = labellingOf(context);
  return computed(() =>
    comparison.value
      ? sceneOf({
          comparison: comparison.value,
          cut: cut.value,
          kind: order.value,
          // A clip of a comparison keeps its name: what else is told of clips changes while they load.
          clips: store.clips.peek(),
          qualifiers: store.qualifiers.peek(),
          ...labelling.value,
        })
      : null,
  );
}

export function createShared(place: Element, context: Context): Shared {
  const { store, theme } = context;
  const { comparison, otherId, hovered } = store.compare;
  const pictures = new PictureSource(context.comparer);
  const facts = new HoverFacts(context.comparer);
  const { scene } = pictures;
  const latest = latestScene(context);
  effect(() => pictures.follow(latest.value));
  effect(() => {
    void comparison.value;
    facts.forget();
  });
  const item = (id: ClipId | null): number | null =>
    id === null ? null : (scene.value?.itemOfClip.get(id) ?? null);
  const items = ({ a, b }: ClipPair): ItemPair => ({ a: item(a), b: item(b) });
  return {
    context,
    scene,
    arrived: arrivedIn(scene, context),
    pictures,
    facts,
    palette: computed(() => {
      void theme.theme.value;
      return comparePalette(place);
    }),
    selected: computed(() => ({ a: item(store.openId.value), b: item(otherId.value) })),
    hovered: computed(() => (hovered.value ? items(hovered.value) : null)),
  };
}

const clipOf = ({ scene }: Shared, item: number): ClipId | undefined =>
  scene.peek()?.comparison.clips[item];

/** Says what is hovered, by items; null: nothing. */
export function hover(shared: Shared, pair: { a: number; b: number } | null): void {
  const [a, b] = pair ? [clipOf(shared, pair.a), clipOf(shared, pair.b)] : [];
  hoverClips(shared, a === undefined || b === undefined ? null : { a, b });
}

export function hoverClips({ context }: Shared, pair: ClipPair | null): void {
  const { hovered } = context.store.compare;
  const before = hovered.peek();
  if (!pair || before?.a !== pair.a || before.b !== pair.b) hovered.value = pair;
}

/** Selects one clip as the first, or as the second, of the pair. */
export function choose(shared: Shared, item: number, as: 'a' | 'b'): void {
  const id = clipOf(shared, item);
  if (id !== undefined) chooseClip(shared, id, as);
}

export function chooseClip({ context }: Shared, id: ClipId, as: 'a' | 'b'): void {
  const { actions, compareActions } = context;
  if (as === 'a') actions.openClip(id);
  else compareActions.selectOther(id);
}

/** Selects both; a clip with itself selects the clip alone. */
export function choosePair(shared: Shared, a: number, b: number): void {
  if (a === b) return choose(shared, a, 'a');
  const [idA, idB] = [clipOf(shared, a), clipOf(shared, b)];
  if (idA !== undefined && idB !== undefined) shared.context.compareActions.selectPair(idA, idB);
}

export function openPair(shared: Shared, a: number, b: number): void {
  if (a === b) return;
  choosePair(shared, a, b);
  shared.context.compareActions.showPage('pair');
}
