/** Clips to choose from in; a list that opens under its button, with a filter, out. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import type { Words } from '../app/i18n/catalogue';
import { keptBeside } from '../common/beside';
import { clipName } from '../common/clip-name';
import { icon } from '../common/icons';
import type { ClipId } from '../engine/types';
import { performerLetter } from '../figure/performer-letter';
import { who } from './who';

export interface ListedClip {
  readonly id: ClipId;
  readonly name: string;
  readonly qualifier: string;
  readonly about: string;
  /** Its place on the page from 0, A; null: it is not there. */
  readonly place: number | null;
  readonly chosen: boolean;
}

export interface ClipListProps {
  readonly id: string;
  readonly label: string;
  readonly words: Words;
  /** null while it is closed: thousands of rows cost what nobody sees. */
  readonly clips: readonly ListedClip[] | null;
  /** Several can be chosen: the list stays open. */
  readonly several: boolean;
  /** Why no more can be chosen; may be empty. */
  readonly notice: string;
  readonly filter: string;
  readonly onFilter: (text: string) => void;
  readonly onOpen: (isOpen: boolean) => void;
  readonly onChoose: (id: ClipId) => void;
}

/** Rows at most: who has more clips than that writes a few letters. */
const mostRows = 100;

/** ↑ ↓ go from the filter through the rows and back. */
function walk(event: KeyboardEvent): void {
  const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  const list = event.currentTarget as HTMLElement;
  if (step === undefined) return;
  event.preventDefault();
  const stops = [...list.querySelectorAll<HTMLElement>('input, .pair-list-row')];
  const next = stops.indexOf(document.activeElement as HTMLElement) + step;
  stops[Math.min(Math.max(next, 0), stops.length - 1)]?.focus();
}

function row(clip: ListedClip, { several, onChoose }: ClipListProps): TemplateResult {
  const choose = (event: Event): void => {
    const list = (event.currentTarget as HTMLElement).closest<HTMLElement>('[popover]');
    if (!several) list?.hidePopover();
    onChoose(clip.id);
  };
  return html`<button
    type="button"
    class="pair-list-row"
    aria-pressed=${String(clip.chosen)}
    @click=${choose}
  >
    <span class="pair-list-mark">
      ${clip.place === null ? nothing : who(performerLetter(clip.place), clip.place)}
    </span>
    <span class="pair-list-name">${clipName(clip.name, clip.qualifier)}</span>
    <span class="pair-list-about">${clip.about}</span>
    ${clip.chosen ? icon('check', 14) : nothing}
  </button>`;
}

function rowsOf(props: ClipListProps, clips: readonly ListedClip[]): TemplateResult {
  const { t } = props.words;
  const wanted = props.filter.trim().toLowerCase();
  const found = clips.filter(({ name, qualifier }) =>
    `${qualifier} ${name}`.toLowerCase().includes(wanted),
  );
  const hidden = found.length - mostRows;
  return html`
    ${found.slice(0, mostRows).map((clip) => row(clip, props))}
    ${found.length === 0 ? html`<p class="pair-list-note">${t('pair.filter.nothing', props.filter)}</p>` : nothing}
    ${hidden > 0 ? html`<p class="pair-list-note">${t('pair.filter.more', hidden)}</p>` : nothing}
  `;
}

export function clipList(props: ClipListProps): TemplateResult {
  const { t } = props.words;
  const onToggle = (event: Event): void => {
    const list = event.currentTarget as HTMLElement;
    const isOpen = list.matches(':popover-open');
    props.onOpen(isOpen);
    if (!isOpen) return;
    props.onFilter('');
    list.querySelector('input')?.focus();
  };
  return html`<div
    id=${props.id}
    class="menu pair-list"
    popover
    role="dialog"
    aria-label=${props.label}
    @beforetoggle=${keptBeside({ opens: props.id, side: 'below', edge: 'left' })}
    @toggle=${onToggle}
    @keydown=${walk}
  >
    <label class="field"
      >${icon('search', 14)}
      <input
        type="search"
        placeholder=${t('pair.filter')}
        aria-label=${t('pair.filter')}
        .value=${live(props.filter)}
        @input=${(event: Event) => props.onFilter((event.target as HTMLInputElement).value)}
      />
    </label>
    ${props.notice === '' ? nothing : html`<p class="pair-list-note">${props.notice}</p>`}
    <div class="pair-list-rows">${props.clips ? rowsOf(props, props.clips) : nothing}</div>
  </div>`;
}
