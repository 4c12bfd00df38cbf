/**
 * How well the distance tells the labels apart: accuracy of the nearest neighbour, R, P and F of the
 * clusters, the confusion of labels, and every error, which a press selects as the pair.
 */
import '../styles/evaluation.css';
import { computed, signal, type ReadonlySignal, type Signal } from '@preact/signals-core';
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Clip } from '../app/clips';
import type { Context } from '../app/context';
import type { Words } from '../app/i18n/catalogue';
import type { Labels } from '../app/labels';
import { icon } from '../common/icons';
import { mount } from '../common/mount';
import type { Evaluation } from '../engine/comparison-types';
import type { ClipId } from '../engine/types';
import { clipNames, type NameOf } from './clip-words';
import { ConfusionCounts, confusionTable } from './confusion-table';
import type { Room } from './confusion-window';
import { errorList } from './error-list';
import { openLabelDialog } from './label-dialog';
import { createScrolling, type Scrolling } from './scrolling';

interface EvaluationProps {
  readonly words: Words;
  readonly evaluation: Evaluation;
  readonly counts: ConfusionCounts;
  readonly room: Signal<Room>;
  readonly scrolling: Scrolling;
  /** Clips that are compared. */
  readonly compared: number;
  readonly clusters: number;
  readonly clips: readonly Clip[];
  readonly nameOf: NameOf;
  readonly labels: Labels;
  readonly placeOf: (label: string) => number;
  readonly selected: { readonly a: ClipId | null; readonly b: ClipId | null };
  readonly onPair: (a: ClipId, b: ClipId) => void;
}

/** So many lines of one kind; the others are counted. */
const mostSingles = 2;

const figure = (value: string, beside: string, about: string): TemplateResult =>
  html`<div class="score">
    <p><span class="score-value">${value}</span> <span class="score-beside">${beside}</span></p>
    <p class="quiet">${about}</p>
  </div>`;

function notes(props: EvaluationProps): string[] {
  const { words, evaluation, compared, clips, nameOf, labels } = props;
  const { t } = words;
  const owner = (label: string): string =>
    nameOf(clips.find(({ id, removed }) => !removed && labels.get(id) === label));
  const { single, labelled } = evaluation;
  const singles = single
    .slice(0, mostSingles)
    .map((label) => t('evaluation.single', owner(label), label));
  const more = single.length - singles.length;
  return [
    ...(compared > labelled ? [t('evaluation.unlabelled', compared - labelled)] : []),
    ...singles,
    ...(more > 0 ? [t('evaluation.single.more', more)] : []),
  ];
}

function scores(props: EvaluationProps): TemplateResult {
  const { words, evaluation, clusters } = props;
  const { t, format } = words;
  const { accuracy, correct, labelled, f, recall, precision } = evaluation;
  const percent = t('unit.percent', format.decimal(accuracy * 100, 1));
  const rates = t('evaluation.r-p', format.decimal(recall, 2), format.decimal(precision, 2));
  return html`<section>
    <h3>${t('evaluation.title')}</h3>
    ${figure(percent, t('evaluation.of', correct, labelled), t('evaluation.leave-one-out'))}
    ${figure(format.decimal(f, 2), rates, t('evaluation.f', clusters))}
    ${notes(props).map(
      (note) => html`<p class="evaluation-note">${icon('info', 14)}<span>${note}</span></p>`,
    )}
  </section>`;
}

function confusion(props: EvaluationProps): TemplateResult {
  const { words, evaluation, counts, room, labels, placeOf, onPair } = props;
  const labelAt = (id: ClipId): string | null => labels.get(id) ?? null;
  // The first of the errors that are counted there.
  const onCell = (own: number, found: number): void => {
    const error = evaluation.errors.find(
      ({ clip, nearest }) =>
        labelAt(clip) === evaluation.labels[own] && labelAt(nearest) === evaluation.labels[found],
    );
    if (error) onPair(error.clip, error.nearest);
  };
  return html`<section class="evaluation-confusion">
    <h3>${words.t('evaluation.confusion')}</h3>
    ${confusionTable({
      words,
      evaluation,
      counts,
      room: room.value,
      placeOf,
      onCell,
      onScroll: (left, top) => (room.value = { ...room.peek(), left, top }),
    })}
  </section>`;
}

function empty({ t }: Words, labelled: boolean): TemplateResult {
  return html`<div class="evaluation-empty">
    <p>${t(labelled ? 'evaluation.waiting' : 'evaluation.empty')}</p>
    ${
      labelled
        ? nothing
        : html`<button type="button" class="button line" @click=${openLabelDialog}>
            ${t('labels.from-names.choose')}
          </button>`
    }
  </div>`;
}

/** What is made once of every evaluation and labelling. */
interface Prepared {
  readonly counts: ReadonlySignal<ConfusionCounts | null>;
  readonly places: ReadonlySignal<ReadonlyMap<string, number>>;
  readonly room: Signal<Room>;
  /** Of the errors. */
  readonly scrolling: Scrolling;
}

function panel(context: Context, { counts, places, room, scrolling }: Prepared): TemplateResult {
  const { store, language, compareActions } = context;
  const { evaluation, comparison, cut, otherId } = store.compare;
  const words = language.words.value;
  const placeOf = places.value;
  const found = evaluation.value;
  if (placeOf.size === 0 || !found || !counts.value || found.labelled === 0)
    return empty(words, placeOf.size > 0 && !found);
  const shown = { evaluation: found, errors: found.errors, counts: counts.value, room, scrolling };
  return html`${[scores, confusion, errorList].map((block) =>
    block({
      ...shown,
      words,
      compared: comparison.value?.clips.length ?? found.labelled,
      clusters: cut.value?.clusters ?? 0,
      clips: store.clips.value,
      nameOf: clipNames(store.qualifiers.value),
      labels: store.labels.value,
      placeOf: (label) => placeOf.get(label) ?? -1,
      selected: { a: store.openId.value, b: otherId.value },
      onPair: (a, b) => compareActions.selectPair(a, b),
    }),
  )}`;
}

/** Scores and errors stand beside it, with room around it and a line; its title over it. */
const besidePx = 481;
const leastRoom = { width: 260, height: 120 } as const;
const mostRoomPx = 560;
const titlePx = 50;

function confusionRoom(place: HTMLElement): Pick<Room, 'width' | 'height'> {
  const { clientWidth, clientHeight } = place;
  return {
    width: Math.max(leastRoom.width, Math.min(mostRoomPx, clientWidth - besidePx)),
    height: Math.max(leastRoom.height, clientHeight - titlePx),
  };
}

export function mountEvaluation(place: HTMLElement, context: Context): void {
  place.classList.add('evaluation');
  place.setAttribute('role', 'region');
  const { store } = context;
  const { evaluation } = store.compare;
  const room = signal<Room>({ left: 0, top: 0, width: 0, height: 0 });
  const height = signal(0);
  const prepared: Prepared = {
    counts: computed(() => evaluation.value && new ConfusionCounts(evaluation.value)),
    places: computed(() => new Map(store.labelNames.value.map((name, index) => [name, index]))),
    room,
    scrolling: createScrolling(height),
  };
  new ResizeObserver(() => {
    room.value = { ...room.peek(), ...confusionRoom(place) };
    height.value = place.clientHeight;
  }).observe(place);
  mount(place, () => {
    place.setAttribute('aria-label', context.language.words.value.t('evaluation.title'));
    return panel(context, prepared);
  });
}
