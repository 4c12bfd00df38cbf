/** What was found of the set in; files in the person's downloads out, one at a time, each with its progress. */
import { signal, untracked, type ReadonlySignal } from '@preact/signals-core';
import { labelledCut } from '../app/comparing-selection';
import type { Context } from '../app/context';
import { failureOf, isAbort } from '../app/failure';
import { saveBlob } from '../common/save-file';
import type { ComparisonExportKind } from '../engine/comparison-types';

export interface FileUnderWay {
  readonly fileName: string;
  /** 0 to 1. */
  readonly done: number;
  readonly elapsedS: number;
}

export interface SetFiles {
  readonly underWay: ReadonlySignal<FileUnderWay | null>;
  readonly save: (kind: ComparisonExportKind) => Promise<void>;
  readonly cancel: () => void;
}

const fileNames: Readonly<Record<ComparisonExportKind, string>> = {
  'features-csv': 'features.csv',
  'features-npy': 'features.npy',
  'matrix-csv': 'distances.csv',
  'matrix-npy': 'distances.npy',
  'tree-newick': 'tree.nwk',
  'evaluation-csv': 'evaluation.csv',
  'evaluation-json': 'evaluation.json',
};

export function createSetFiles({ store, comparer, language }: Context): SetFiles {
  const underWay = signal<FileUnderWay | null>(null);
  let abort = new AbortController();
  const save = async (kind: ComparisonExportKind): Promise<void> => {
    const labelled = untracked(() => labelledCut(store));
    if (!labelled || underWay.peek()) return;
    const fileName = fileNames[kind];
    abort = new AbortController();
    const { signal } = abort;
    const startMs = performance.now();
    const onProgress = ({ done }: { readonly done: number }): void => {
      if (signal.aborted) return;
      underWay.value = { fileName, done, elapsedS: (performance.now() - startMs) / 1000 };
    };
    onProgress({ done: 0 });
    try {
      saveBlob(fileName, await comparer.exportFile(kind, labelled, { signal, onProgress }));
      store.toast.value = { kind: 'done', text: language.words.peek().t('toast.saved', fileName) };
    } catch (error) {
      if (signal.aborted || isAbort(error)) return;
      const { t, failure } = language.words.peek();
      const text = t('toast.error', fileName, failure(failureOf(error)));
      store.toast.value = { kind: 'error', text };
    } finally {
      if (!signal.aborted) underWay.value = null;
    }
  };
  const cancel = (): void => {
    abort.abort();
    underWay.value = null;
  };
  return { underWay, save, cancel };
}
