/**
 * The comparison, the selection and the labels in; why the selected pair differs, the neighbours of the
 * open clip, and how well labels are told apart, out.
 */
import { batch, effect } from '@preact/signals-core';
import type {
  Comparer,
  Comparison,
  Evaluation,
  Explanation,
  LabelledCut,
  Neighbour,
} from '../engine/comparison-types';
import type { ClipId } from '../engine/types';
import { LatestAnswer } from './latest-answer';
import type { Store } from './store';

/** Neighbours of the open clip that are told. */
const mostNeighbours = 100;

const isIn = (comparison: Comparison | null, clip: ClipId | null): clip is ClipId =>
  clip !== null && (comparison?.clips.includes(clip) ?? false);

/** The labels of the items of a comparison and its cut; null before there is one. */
export function labelledCut({ compare, labels }: Store): LabelledCut | null {
  const comparison = compare.comparison.value;
  const cut = compare.cut.value;
  if (!comparison || !cut) return null;
  const labelOf = (clip: ClipId): string | null => labels.value.get(clip) ?? null;
  return { clusters: cut.clusters, labels: Array.from(comparison.clips, labelOf) };
}

const isSame = (a: LabelledCut, b: LabelledCut): boolean =>
  a.clusters === b.clusters &&
  a.labels.length === b.labels.length &&
  a.labels.every((label, item) => label === b.labels[item]);

/** Returns what ends it. */
export function followSelection(store: Store, comparer: Comparer): () => void {
  const ends = [
    explainSelection(store, comparer),
    findNeighbours(store, comparer),
    evaluateLabels(store, comparer),
    effect(() => leaveRemoved(store)),
  ];
  return () => ends.forEach((end) => end());
}

// A failure is that of the comparison, which tells it, or of one that has been replaced meanwhile.
const quiet = (): void => undefined;

function explainSelection({ openId, compare }: Store, comparer: Comparer): () => void {
  const { comparison, otherId, explanation } = compare;
  const answers = new LatestAnswer<Explanation>((found) => (explanation.value = found), quiet);
  return effect(() => {
    const [a, b] = [openId.value, otherId.value];
    if (isIn(comparison.value, a) && isIn(comparison.value, b) && a !== b) {
      answers.ask(() => comparer.explain(a, b));
      return;
    }
    answers.forget();
    explanation.value = null;
  });
}

function findNeighbours({ openId, compare }: Store, comparer: Comparer): () => void {
  const { comparison, neighbours } = compare;
  const answers = new LatestAnswer<readonly Neighbour[]>(
    (found) => (neighbours.value = found),
    quiet,
  );
  return effect(() => {
    const clip = openId.value;
    if (isIn(comparison.value, clip)) {
      answers.ask(() => comparer.neighbours(clip, mostNeighbours));
      return;
    }
    answers.forget();
    neighbours.value = [];
  });
}

function evaluateLabels(store: Store, comparer: Comparer): () => void {
  const { evaluation } = store.compare;
  const answers = new LatestAnswer<Evaluation>((found) => (evaluation.value = found), quiet);
  let asked: { readonly of: Comparison | null; readonly labelled: LabelledCut } | null = null;
  return effect(() => {
    const of = store.compare.comparison.value;
    const labelled = labelledCut(store);
    // Labels of clips that only come say nothing new of those compared.
    if (labelled && asked?.of === of && isSame(asked.labelled, labelled)) return;
    asked = labelled && { of, labelled };
    if (labelled?.labels.some((label) => label !== null)) {
      answers.ask(() => comparer.evaluate(labelled));
      return;
    }
    answers.forget();
    evaluation.value = null;
  });
}

/** A clip that is gone, or that has become the open one, is not the other one any more. */
function leaveRemoved({ clips, openId, compare }: Store): void {
  const all = clips.value;
  const stays = (id: ClipId): boolean => all[id]?.removed === false && id !== openId.value;
  const other = compare.otherId.value;
  const also = compare.alsoIds.value;
  batch(() => {
    if (other !== null && !stays(other)) compare.otherId.value = null;
    if (!also.every(stays)) compare.alsoIds.value = also.filter(stays);
  });
}
