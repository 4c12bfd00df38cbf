/** The clips whose nearest has another label in; one row for each out, of which only those in sight exist. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { repeat } from 'lit-html/directives/repeat.js';
import type { Clip } from '../app/clips';
import type { Words } from '../app/i18n/catalogue';
import type { Labels } from '../app/labels';
import { styled } from '../common/directives';
import { labelMark } from '../common/label-mark';
import type { Evaluation } from '../engine/comparison-types';
import type { ClipId } from '../engine/types';
import { rowWindow } from '../library/row-window';
import { nameLine, type NameOf } from './clip-words';
import type { Scrolling } from './scrolling';

type EvaluationError = Evaluation['errors'][number];

export interface ErrorListProps {
  readonly words: Words;
  readonly errors: readonly EvaluationError[];
  readonly clips: readonly Clip[];
  readonly nameOf: NameOf;
  readonly labels: Labels;
  readonly placeOf: (label: string) => number;
  readonly selected: { readonly a: ClipId | null; readonly b: ClipId | null };
  readonly scrolling: Scrolling;
  readonly onPair: (a: ClipId, b: ClipId) => void;
}

const rowHeightPx = 24;

function clipOf({ clips, nameOf, labels, placeOf }: ErrorListProps, id: ClipId): TemplateResult {
  const label = labels.get(id) ?? null;
  const name = nameOf(clips[id]);
  const title = label === null ? name : `${name} · ${label}`;
  return html`<span class="error-clip" title=${title}
    >${label === null ? nothing : labelMark(placeOf(label))}${nameLine(name)}<span class="spoken">
      ${label}</span
    ></span
  >`;
}

function row(
  props: ErrorListProps,
  { clip, nearest }: EvaluationError,
  index: number,
): TemplateResult {
  const { words, errors, selected, onPair } = props;
  return html`<li aria-posinset=${index + 1} aria-setsize=${errors.length}>
    <button
      type="button"
      class="error-row"
      aria-pressed=${String(selected.a === clip && selected.b === nearest)}
      @click=${() => onPair(clip, nearest)}
    >
      ${clipOf(props, clip)}<span class="quiet">${words.t('evaluation.nearest')}</span
      >${clipOf(props, nearest)}
    </button>
  </li>`;
}

export function errorList(props: ErrorListProps): TemplateResult {
  const { words, errors, scrolling } = props;
  const { top, height } = scrolling;
  const { first, end } = rowWindow(errors.length, rowHeightPx, top.value, height.value);
  const onScroll = (event: Event): void => {
    top.value = (event.currentTarget as HTMLElement).scrollTop;
  };
  const extent = {
    height: `${errors.length * rowHeightPx}px`,
    'padding-top': `${first * rowHeightPx}px`,
  };
  return html`<section class="evaluation-errors" @scroll=${onScroll}>
    <h3>${words.t('evaluation.errors', errors.length)}</h3>
    <ul ${styled(extent)}>
      ${repeat(
        errors.slice(first, end),
        ({ clip }) => clip,
        (error, offset) => row(props, error, first + offset),
      )}
    </ul>
  </section>`;
}
