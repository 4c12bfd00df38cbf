/** The tabs beside the matrix: why the two clips differ, what is near the first, and every clip as a row. */
import '../styles/compare-side.css';
import { computed, signal } from '@preact/signals-core';
import { html, type TemplateResult } from 'lit-html';
import type { Clip } from '../app/clips';
import type { CompareTab } from '../app/compare-store';
import type { Context } from '../app/context';
import { icon } from '../common/icons';
import { mount } from '../common/mount';
import type { ClipId } from '../engine/types';
import { createClipFigures } from './clip-figures';
import { clipNames, type LabelOf } from './clip-words';
import { neighbourList } from './neighbour-list';
import { createScrolling } from './scrolling';
import { createTableTab } from './table-tab';
import { whyPanel } from './why-panel';

const tabs: readonly CompareTab[] = ['why', 'neighbours', 'table'];
const tabId = (tab: CompareTab): string => `compare-tab-${tab}`;
const panelId = 'compare-tab-panel';

/** The tab that a key leads to; null for other keys. */
export function compareTabByKey(key: string, chosen: CompareTab): CompareTab | null {
  const index = tabs.indexOf(chosen);
  const next = { ArrowLeft: index - 1, ArrowRight: (index + 1) % tabs.length, Home: 0, End: -1 }[
    key
  ];
  return next === undefined ? null : (tabs.at(next) ?? null);
}

function head({ store, language, compareActions }: Context): TemplateResult {
  const { t } = language.words.value;
  const chosen = store.compare.tab.value;
  const onKey = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const tab = compareTabByKey(event.key, chosen);
    if (!tab) return;
    event.preventDefault();
    compareActions.setTab(tab);
    document.getElementById(tabId(tab))?.focus();
  };
  const tab = (name: CompareTab): TemplateResult =>
    html`<button
      type="button"
      id=${tabId(name)}
      class="tab"
      role="tab"
      aria-selected=${String(name === chosen)}
      aria-controls=${panelId}
      tabindex=${name === chosen ? 0 : -1}
      @click=${() => compareActions.setTab(name)}
    >
      ${t(`side.${name}`)}
    </button>`;
  return html`<div class="side-head">
    <div class="side-tabs" role="tablist" aria-label=${t('side.tabs')} @keydown=${onKey}>
      ${tabs.map(tab)}
    </div>
    <button
      type="button"
      class="button line open-pair"
      ?disabled=${store.openId.value === null || store.compare.otherId.value === null}
      @click=${() => compareActions.showPage('pair')}
    >
      ${icon('columns-2', 14)}${t('side.open-pair')}
    </button>
  </div>`;
}

const clipOf = (clips: readonly Clip[], id: ClipId | null): Clip | null => {
  const clip = id === null ? undefined : clips[id];
  return clip && !clip.removed ? clip : null;
};

function createWhyTab(context: Context): () => TemplateResult {
  const { store, language, compareActions, engine } = context;
  const { otherId, explanation, neighbours } = store.compare;
  const a = computed(() => store.openClip.value);
  const b = computed(() => clipOf(store.clips.value, otherId.value));
  const figuresA = createClipFigures(engine, a);
  const figuresB = createClipFigures(engine, b);
  return () => {
    const found = explanation.value;
    return whyPanel({
      words: language.words.value,
      a: a.value,
      b: b.value,
      figuresA: figuresA.value,
      figuresB: figuresB.value,
      outdated: found?.a !== a.value?.id || found?.b !== b.value?.id,
      explanation: found,
      neighbours: neighbours.value,
      clips: store.clips.value,
      nameOf: clipNames(store.qualifiers.value),
      labelOf: labelReader(context),
      onNeighbour: (id) => compareActions.selectOther(id),
    });
  };
}

function labelReader({ store }: Context): (id: ClipId) => LabelOf | null {
  const labels = store.labels.value;
  const names = store.labelNames.value;
  return (id) => {
    const name = labels.get(id) ?? null;
    return name === null ? null : { name, index: names.indexOf(name) };
  };
}

function createNeighboursTab(
  context: Context,
  scrolling: ReturnType<typeof createScrolling>,
): () => TemplateResult {
  const { store, language, compareActions } = context;
  return () =>
    neighbourList({
      words: language.words.value,
      a: store.openClip.value,
      neighbours: store.compare.neighbours.value,
      clips: store.clips.value,
      otherId: store.compare.otherId.value,
      nameOf: clipNames(store.qualifiers.value),
      labelOf: labelReader(context),
      scrollTop: scrolling.top.value,
      viewHeight: scrolling.height.value,
      onChoose: (id) => compareActions.selectOther(id),
      onOpenPair: (id) => {
        compareActions.selectOther(id);
        compareActions.showPage('pair');
      },
      onScroll: (top) => (scrolling.top.value = top),
    });
}

export function mountSideTabs(place: HTMLElement, context: Context): void {
  const height = signal(0);
  new ResizeObserver(() => (height.value = place.clientHeight)).observe(place);
  const contents: Readonly<Record<CompareTab, () => TemplateResult>> = {
    why: createWhyTab(context),
    neighbours: createNeighboursTab(context, createScrolling(height)),
    table: createTableTab(context, createScrolling(height)),
  };
  mount(place, () => {
    const tab = context.store.compare.tab.value;
    return html`${head(context)}
      <div
        id=${panelId}
        class="side-panel side-${tab}"
        role="tabpanel"
        aria-labelledby=${tabId(tab)}
      >
        ${contents[tab]()}
      </div>`;
  });
}
