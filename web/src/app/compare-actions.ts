/** What a person can do while comparing, in verbs; views of the pages Compare and Pair end in these. */
import { batch } from '@preact/signals-core';
import type { ComparisonSettings } from '../engine/comparison-types';
import type { ClipId } from '../engine/types';
import type { CompareTab, LabelRule, MatrixOrder, Page } from './compare-store';
import type { History } from './history';
import type { Words } from './i18n/catalogue';
import { withRename } from './labels';
import type { Store } from './store';

export interface CompareActions {
  readonly showPage: (page: Page) => void;
  /** Selects two clips in every view: the first is the open one. */
  readonly selectPair: (a: ClipId, b: ClipId) => void;
  readonly selectOther: (b: ClipId | null) => void;
  /** The distance and how the tree is made; a distance that knows mirrors wants the group average. */
  readonly setComparisonSettings: (settings: ComparisonSettings) => void;
  /** Clusters; null: as many as found. */
  readonly setCut: (clusters: number | null) => void;
  readonly setOrder: (order: MatrixOrder) => void;
  readonly setTab: (tab: CompareTab) => void;
  readonly setLabelRule: (rule: LabelRule) => void;
  /** '' takes the label away. */
  readonly labelByHand: (ids: readonly ClipId[], label: string) => void;
  /** Of all its clips, also of those that come later; a name that there is already joins both. */
  readonly renameLabel: (from: string, to: string) => void;
  /** Another clip on the page Pair. */
  readonly addToPair: (id: ClipId) => void;
  readonly removeFromPair: (id: ClipId) => void;
}

/** Clips on one stage, at most. */
export const mostTogether = 20;

export interface CompareActionParts {
  readonly store: Store;
  readonly history: History;
  readonly words: () => Words;
  readonly openClip: (id: ClipId | null) => void;
}

export function createCompareActions(parts: CompareActionParts): CompareActions {
  return new Verbs(parts);
}

class Verbs implements CompareActions {
  private readonly parts: CompareActionParts;

  constructor(parts: CompareActionParts) {
    this.parts = parts;
  }

  showPage(page: Page): void {
    this.state.page.value = page;
  }

  selectPair(a: ClipId, b: ClipId): void {
    batch(() => {
      this.parts.openClip(a);
      this.selectOther(b);
    });
  }

  selectOther(b: ClipId | null): void {
    this.state.otherId.value = b === this.parts.store.openId.peek() ? null : b;
  }

  setComparisonSettings(settings: ComparisonSettings): void {
    const linkage = settings.distance.mirrorAware ? 'average' : settings.linkage;
    this.state.settings.value = { ...settings, linkage };
  }

  setCut(clusters: number | null): void {
    this.state.cutClusters.value = clusters;
  }

  setOrder(order: MatrixOrder): void {
    this.state.order.value = order;
  }

  setTab(tab: CompareTab): void {
    this.state.tab.value = tab;
  }

  setLabelRule(rule: LabelRule): void {
    const { labelRule } = this.state;
    const before = labelRule.peek();
    if (JSON.stringify(before) === JSON.stringify(rule)) return;
    this.parts.history.run({
      label: this.parts.words().t('change.labels'),
      apply: () => (labelRule.value = rule),
      revert: () => (labelRule.value = before),
    });
  }

  labelByHand(ids: readonly ClipId[], label: string): void {
    const { handLabels } = this.state;
    const before = handLabels.peek();
    const after = new Map([...before, ...ids.map((id) => [id, label] as const)]);
    this.parts.history.run({
      label: this.parts.words().t('change.label'),
      apply: () => (handLabels.value = after),
      revert: () => (handLabels.value = before),
    });
  }

  renameLabel(from: string, to: string): void {
    const { handLabels, labelRenames } = this.state;
    if (to === '' || to === from) return;
    const [hand, renames] = [handLabels.peek(), labelRenames.peek()];
    const newHand = new Map([...hand].map(([id, label]) => [id, label === from ? to : label]));
    const set = (labels: typeof hand, names: typeof renames): void =>
      batch(() => {
        handLabels.value = labels;
        labelRenames.value = names;
      });
    this.parts.history.run({
      label: this.parts.words().t('change.label'),
      apply: () => set(newHand, withRename(renames, from, to)),
      revert: () => set(hand, renames),
    });
  }

  addToPair(id: ClipId): void {
    const { alsoIds, otherId } = this.state;
    const shown = [this.parts.store.openId.peek(), otherId.peek(), ...alsoIds.peek()];
    if (shown.includes(id) || alsoIds.peek().length + 2 >= mostTogether) return;
    if (otherId.peek() === null) otherId.value = id;
    else alsoIds.value = [...alsoIds.peek(), id];
  }

  /** The next clip takes the place of one of the first two. */
  removeFromPair(id: ClipId): void {
    const { alsoIds, otherId } = this.state;
    const [next = null, ...rest] = alsoIds.peek();
    const openId = this.parts.store.openId.peek();
    batch(() => {
      if (id !== openId && id !== otherId.peek()) {
        alsoIds.value = alsoIds.peek().filter((other) => other !== id);
        return;
      }
      const other = otherId.peek();
      if (id === openId && other === null) return;
      if (id === openId) this.parts.openClip(other);
      otherId.value = next;
      alsoIds.value = rest;
    });
  }

  private get state() {
    return this.parts.store.compare;
  }
}
