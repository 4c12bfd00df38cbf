/** What a person can do on the page, in verbs; every view's event ends in one of them. */
import { batch } from '@preact/signals-core';
import type { ClipId, ClipSource, Engine, ExportKind, MethodOptions } from '../engine/types';
import { saveBlob, saveText } from '../common/save-file';
import { createAnalysis } from './analysis';
import { createBacklog } from './backlog';
import { patchClips } from './clip-changes';
import type { Clip } from './clips';
import { decisionLabels, withDecision, type DecisionChange, type JointsChange } from './decisions';
import { failureOf } from './failure';
import type { History } from './history';
import type { Words } from './i18n/catalogue';
import type { Given } from './intake';
import { createLoader } from './loading';
import { createOpener } from './opening';
import { createOptionChanges, type OptionKey } from './option-changes';
import { toastOfReport } from './report';
import type { Store } from './store';

export interface Actions {
  readonly take: (given: readonly Given[]) => void;
  readonly openSample: (id: string) => void;
  readonly cancelLoading: () => void;
  readonly openClip: (id: ClipId | null) => void;
  readonly openNeighbour: (direction: 1 | -1) => void;
  readonly choosePerformer: (index: number) => void;
  /** One or several, undone together. */
  readonly remove: (...ids: readonly ClipId[]) => void;
  readonly decide: (change: DecisionChange) => void;
  /** Another value of a parameter of the method, for all clips; undefined: its default. */
  readonly setOption: <Key extends keyof MethodOptions>(
    key: Key,
    value: MethodOptions[Key] | undefined,
  ) => void;
  /** The same joints for several clips of one skeleton, undone together. */
  readonly decideJoints: (changes: readonly JointsChange[]) => void;
  /** Parameters back to their defaults in one step; without a list, every one. */
  readonly resetOptions: (keys?: readonly OptionKey[]) => void;
  readonly exportClip: (id: ClipId, kind: ExportKind) => void;
  /** The stage as it stands, a PNG named after clip and frame. */
  readonly savePicture: () => void;
  readonly undo: () => void;
  readonly redo: () => void;
}

export interface ActionParts {
  readonly engine: Engine;
  readonly store: Store;
  readonly history: History;
  readonly words: () => Words;
}

const extensions: Readonly<Record<ExportKind, string>> = {
  'keyposes-csv': 'csv',
  'keyposes-json': 'json',
  'candidates-csv': 'csv',
  'candidates-json': 'json',
  'traces-csv': 'csv',
  'traces-json': 'json',
};

export function createActions(parts: ActionParts): Actions {
  return new PageActions(parts);
}

class PageActions implements Actions {
  private readonly parts: ActionParts;
  private readonly analysis;
  private readonly loader;
  private readonly opener;
  private readonly options;

  constructor(parts: ActionParts) {
    const { engine, store } = parts;
    this.parts = parts;
    this.analysis = createAnalysis(engine, store, (name, error) => this.tellError(name, error));
    this.options = createOptionChanges(parts, this.analysis, () => performance.now());
    this.opener = createOpener(store, (id) => this.openClip(id));
    const now = (): number => performance.now();
    this.loader = createLoader({
      engine,
      store,
      analysis: this.analysis,
      backlog: createBacklog({ store, analysis: this.analysis, now }),
      now,
      onStart: (id) => this.opener.started(id),
      onSettled: (id, batchSize) => this.opener.settled(id, batchSize),
      onEnd: (report) => {
        this.opener.ended();
        if (report.known.length === 1 && report.clips.length === 0) this.openClip(report.known[0]);
        const toast = toastOfReport(report, store, parts.words(), (id) => this.openClip(id));
        if (toast) store.toast.value = toast;
      },
    });
  }

  take(given: readonly Given[]): void {
    void this.loader.take(given);
  }

  openSample(id: string): void {
    this.parts.engine
      .sample(id)
      .then((source: ClipSource) => this.loader.add([source]))
      .catch((error: unknown) => this.tellError(id, error));
  }

  cancelLoading(): void {
    this.loader.cancel();
  }

  openClip(id: ClipId | null): void {
    const { store } = this.parts;
    if (id === store.openId.peek()) return;
    this.parts.engine.keep(id);
    batch(() => {
      store.openId.value = id;
      store.performer.value = 0;
      store.hoverFrame.value = null;
      store.zoom.value = null;
    });
  }

  openNeighbour(direction: 1 | -1): void {
    const shown = this.parts.store.shown.peek();
    const index = shown.findIndex(({ id }) => id === this.parts.store.openId.peek());
    const next = shown[index + direction];
    if (next) this.openClip(next.id);
  }

  choosePerformer(index: number): void {
    this.parts.store.performer.value = index;
  }

  remove(...ids: readonly ClipId[]): void {
    const { store, history, words, engine } = this.parts;
    const [first] = ids;
    if (first === undefined) return;
    const { t } = words();
    const name = store.clips.peek()[first]?.source.name ?? '';
    const openId = store.openId.peek();
    const one = ids.length === 1;
    history.run({
      label: one ? t('change.remove', name) : t('change.remove.several', ids.length),
      apply: () => this.takeOut(ids),
      revert: () => {
        patchClips(
          store,
          ids.map((id) => [id, { removed: false }]),
        );
        if (openId !== null && ids.includes(openId)) this.openClip(openId);
      },
      settle: () => ids.forEach((id) => engine.close(id)),
    });
    const undo = { label: t('toast.undo'), run: () => this.undo() };
    const text = one ? t('toast.removed', name) : t('toast.removed.several', ids.length);
    store.toast.value = { kind: 'done', text, action: undo };
  }

  decide(change: DecisionChange): void {
    const { store, history, words } = this.parts;
    const before = store.clips.peek()[change.id]?.decisions;
    if (!before || before[change.key] === change.value) return;
    const after = withDecision(before, change);
    history.run({
      label: words().t(decisionLabels[change.key]),
      apply: () => this.analysis.decide(change.id, after),
      revert: () => this.analysis.decide(change.id, before),
    });
  }

  decideJoints(changes: readonly JointsChange[]): void {
    const { store, history, words } = this.parts;
    const both = changes.flatMap(({ id, joints }) => {
      const before = store.clips.peek()[id]?.decisions;
      if (!before) return [];
      const value = joints.length === 0 ? undefined : joints;
      return [{ id, before, after: withDecision(before, { key: 'joints', value }) }];
    });
    if (both.length === 0) return;
    history.run({
      label: words().t(decisionLabels.joints),
      apply: () => both.forEach(({ id, after }) => this.analysis.decide(id, after)),
      revert: () => both.forEach(({ id, before }) => this.analysis.decide(id, before)),
    });
  }

  setOption<Key extends keyof MethodOptions>(
    key: Key,
    value: MethodOptions[Key] | undefined,
  ): void {
    this.options.set(key, value);
  }

  resetOptions(keys?: readonly OptionKey[]): void {
    this.options.reset(keys);
  }

  exportClip(id: ClipId, kind: ExportKind): void {
    const { engine, store, words } = this.parts;
    const name = store.clips.peek()[id]?.source.name ?? '';
    const [content] = kind.split('-');
    const fileName = `${name.replace(/\.bvh$/i, '')}.${content}.${extensions[kind]}`;
    engine
      .exportText(id, kind)
      .then((text) => {
        saveText(fileName, text, extensions[kind] === 'csv' ? 'text/csv' : 'application/json');
        store.toast.value = { kind: 'done', text: words().t('toast.saved', fileName) };
      })
      .catch((error: unknown) => this.tellError(name, error));
  }

  savePicture(): void {
    const { store, words } = this.parts;
    const name = store.openClip.peek()?.source.name ?? '';
    const fileName = `${name.replace(/\.bvh$/i, '')}.${store.playback.peek().frame}.png`;
    store.picture
      .peek()?.()
      .then((blob) => {
        saveBlob(fileName, blob);
        store.toast.value = { kind: 'done', text: words().t('toast.saved', fileName) };
      })
      .catch((error: unknown) => this.tellError(name, error));
  }

  undo(): void {
    this.parts.store.toast.value = null;
    this.parts.history.undo();
  }

  redo(): void {
    this.parts.store.toast.value = null;
    this.parts.history.redo();
  }

  /** Out of the library; an open clip gives its place to its neighbour that stays. */
  private takeOut(ids: readonly ClipId[]): void {
    const { store } = this.parts;
    const gone = new Set(ids);
    const shown = store.shown.peek();
    const openId = store.openId.peek();
    const index = shown.findIndex(({ id }) => id === openId);
    const stays = ({ id }: Clip): boolean => !gone.has(id);
    const neighbour = shown.slice(index + 1).find(stays) ?? shown.slice(0, index).findLast(stays);
    batch(() => {
      patchClips(
        store,
        ids.map((id) => [id, { removed: true }]),
      );
      store.ticked.value = new Set([...store.ticked.peek()].filter((id) => !gone.has(id)));
      if (openId !== null && gone.has(openId)) this.openClip(neighbour?.id ?? null);
    });
  }

  private tellError(name: string, error: unknown): void {
    const { t, failure } = this.parts.words();
    this.parts.store.toast.value = {
      kind: 'error',
      text: t('toast.error', name, failure(failureOf(error))),
    };
  }
}
