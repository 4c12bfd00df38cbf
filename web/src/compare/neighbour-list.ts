/** The tab "Neighbours": all clips from the nearest to the farthest from the first of the pair. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { repeat } from 'lit-html/directives/repeat.js';
import type { Clip } from '../app/clips';
import type { Words } from '../app/i18n/catalogue';
import { drawn, styled } from '../common/directives';
import { labelMark } from '../common/label-mark';
import type { Neighbour } from '../engine/comparison-types';
import type { ClipId } from '../engine/types';
import { drawFlatFigure, fitFigure } from '../figure/draw-flat-figure';
import { rowWindow, scrollToRow } from '../library/row-window';
import { mirrorSign, nameLine, type LabelOf, type NameOf } from './clip-words';
import { distanceNumber } from './distance-number';

export const neighbourHeightPx = 44;
const thumbnailPx = 36;
const paddingPx = 2.5;

export interface NeighbourListProps {
  readonly words: Words;
  readonly a: Clip | null;
  readonly neighbours: readonly Neighbour[];
  readonly clips: readonly Clip[];
  readonly otherId: ClipId | null;
  readonly nameOf: NameOf;
  readonly labelOf: (id: ClipId) => LabelOf | null;
  readonly scrollTop: number;
  readonly viewHeight: number;
  readonly onChoose: (id: ClipId) => void;
  readonly onOpenPair: (id: ClipId) => void;
  readonly onScroll: (top: number) => void;
}

function thumbnail(clip: Clip | undefined): TemplateResult {
  const figure = clip?.thumbnail ?? null;
  const draw = (svg: Element): void => {
    if (figure) drawFlatFigure(svg, figure, fitFigure(figure, thumbnailPx, thumbnailPx, paddingPx));
  };
  return html`<svg
    class="thumbnail"
    viewBox="0 0 ${thumbnailPx} ${thumbnailPx}"
    aria-hidden="true"
    ${drawn(figure, draw)}
  ></svg>`;
}

function row(
  props: NeighbourListProps,
  one: Neighbour,
  index: number,
  tabStop: boolean,
): TemplateResult {
  const { words, clips, otherId, nameOf, labelOf, neighbours, onChoose, onOpenPair } = props;
  const clip = clips[one.clip];
  const label = labelOf(one.clip);
  return html`<li
    aria-setsize=${neighbours.length}
    aria-posinset=${index + 1}
    ${styled({ transform: `translateY(${index * neighbourHeightPx}px)` })}
  >
    <button
      type="button"
      class="neighbour"
      data-neighbour=${one.clip}
      tabindex=${tabStop ? 0 : -1}
      aria-pressed=${String(otherId === one.clip)}
      @click=${() => onChoose(one.clip)}
      @dblclick=${() => onOpenPair(one.clip)}
    >
      <span class="neighbour-rank">${words.format.integer(index + 1)}</span>
      ${thumbnail(clip)}
      <span class="neighbour-text"
        >${nameLine(nameOf(clip))}<span class="neighbour-label"
          >${label ? html`${labelMark(label.index)}${label.name}` : nothing}</span
        ></span
      >
      <span class="neighbour-distance"
        >${distanceNumber(words.format, one.distance)}${one.mirrored ? mirrorSign(words) : nothing}</span
      >
    </button>
  </li>`;
}

/** In sight and in focus; the row is drawn with the next frame. */
function bringTo(list: HTMLElement, place: number, clip: ClipId): void {
  const { scrollTop, clientHeight } = list;
  list.scrollTop = scrollToRow(place, neighbourHeightPx, scrollTop, clientHeight);
  requestAnimationFrame(() =>
    requestAnimationFrame(() =>
      list.querySelector<HTMLElement>(`[data-neighbour="${clip}"]`)?.focus({ preventScroll: true }),
    ),
  );
}

function onKey(props: NeighbourListProps, event: KeyboardEvent): void {
  const { neighbours, otherId, onChoose } = props;
  const last = neighbours.length - 1;
  const focused = Number((event.target as HTMLElement).dataset['neighbour'] ?? otherId);
  const index = neighbours.findIndex(({ clip }) => clip === focused);
  const next = { ArrowDown: index + 1, ArrowUp: index - 1, Home: 0, End: last }[event.key];
  if (next === undefined) return;
  event.preventDefault();
  const place = Math.max(0, Math.min(last, next));
  const chosen = neighbours[place];
  if (!chosen) return;
  onChoose(chosen.clip);
  bringTo(event.currentTarget as HTMLElement, place, chosen.clip);
}

export function neighbourList(props: NeighbourListProps): TemplateResult {
  const { words, a, neighbours, nameOf, otherId } = props;
  if (!a || neighbours.length === 0)
    return html`<p class="side-hint">${words.t(a ? 'neighbours.none' : 'why-pair.none')}</p>`;
  const { first, end } = rowWindow(
    neighbours.length,
    neighbourHeightPx,
    props.scrollTop,
    props.viewHeight,
  );
  const inSight = neighbours.slice(first, end);
  const hasChosen = inSight.some(({ clip }) => clip === otherId);
  const onScroll = (event: Event): void => props.onScroll((event.target as HTMLElement).scrollTop);
  return html`<h3 class="neighbour-title">${words.t('neighbours.nearest-to', nameOf(a))}</h3>
    <div
      class="neighbour-list"
      @scroll=${onScroll}
      @keydown=${(event: KeyboardEvent) => onKey(props, event)}
    >
      <ol ${styled({ height: `${neighbours.length * neighbourHeightPx}px` })}>
        ${repeat(
          inSight,
          ({ clip }) => clip,
          (one, offset) =>
            row(props, one, first + offset, hasChosen ? one.clip === otherId : offset === 0),
        )}
      </ol>
    </div>`;
}
