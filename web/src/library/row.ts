/** One clip of the library: its most unusual keypose, its name, what is known of it. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { isAnalysed, keyposeCount, lengthOf, type Clip } from '../app/clips';
import type { Words } from '../app/i18n/catalogue';
import { notesOf, warningsAmong } from '../app/notes';
import { iconButton } from '../common/buttons';
import { clipName } from '../common/clip-name';
import { drawn, styled } from '../common/directives';
import { icon } from '../common/icons';
import { labelMark } from '../common/label-mark';
import { drawFlatFigure, fitFigure } from '../figure/draw-flat-figure';

export const rowHeightPx = 44;

export interface RowLabel {
  readonly name: string;
  /** Its place among all labels. */
  readonly index: number;
}

export interface RowProps {
  readonly words: Words;
  readonly clip: Clip;
  readonly qualifier: string;
  readonly label: RowLabel | null;
  /** Its label stands over it: it is only spoken. */
  readonly grouped: boolean;
  readonly open: boolean;
  /** The second of the selected pair. */
  readonly other: boolean;
  readonly ticked: boolean;
  readonly top: number;
  /** Whether the Tab key stops at this row. */
  readonly tabStop: boolean;
  /** From 0, of `count` rows. */
  readonly index: number;
  readonly count: number;
  readonly onPress: (event: MouseEvent) => void;
  readonly onRemove: () => void;
}

const thumbnailPx = 36;
const paddingPx = 2.5;

function thumbnail({ clip }: RowProps): TemplateResult {
  if (clip.status === 'failed')
    return html`<span class="thumbnail failed">${icon('octagon-x')}</span>`;
  const draw = (svg: Element): void => {
    const { thumbnail: figure } = clip;
    if (figure) drawFlatFigure(svg, figure, fitFigure(figure, thumbnailPx, thumbnailPx, paddingPx));
  };
  return html`<svg
    class="thumbnail"
    viewBox="0 0 36 36"
    aria-hidden="true"
    ${drawn(clip.thumbnail, draw)}
  ></svg>`;
}

/** "line 214: Found 92 values …": a reason with its place. */
export function reasonOf({ t, failure }: Words, clip: Clip): string {
  if (!clip.failure) return '';
  const reason = failure(clip.failure);
  return clip.failure.line === null
    ? reason
    : t('toast.error', t('place.line', String(clip.failure.line)), reason);
}

/** "6.0 s · 120 Hz". */
export function lengthText({ t, format }: Words, seconds: number): string {
  const { text, inSeconds } = format.duration(seconds);
  return inSeconds ? t('unit.seconds', text) : text;
}

function facts({ words, clip }: RowProps): TemplateResult {
  const { t, format } = words;
  if (clip.status === 'failed')
    return html`<span class="clip-facts" title=${reasonOf(words, clip)}
      >${reasonOf(words, clip)}</span
    >`;
  if (!clip.extent) {
    const stage = t(
      `library.${clip.status === 'waiting' || clip.status === 'reading' ? clip.status : 'analysing'}`,
    );
    return html`<progress
      class="bar"
      max="1"
      .value=${clip.progress}
      aria-label=${stage}
    ></progress>`;
  }
  if (clip.extent.frames < 2) {
    const what = t(clip.extent.frames === 1 ? 'library.pose' : 'library.skeleton');
    return html`<span class="clip-facts">${what}</span>`;
  }
  const length = lengthText(words, lengthOf(clip.extent));
  const rate = t('unit.hertz', format.short(1 / clip.extent.frameTimeS, 2));
  return html`<span class="clip-facts">${length} · ${rate}</span>`;
}

/** The name is spoken, and shown by its tip. */
function labelOf({ words: { t }, label, grouped }: RowProps): TemplateResult | typeof nothing {
  if (!label) return nothing;
  const name = t('library.label', label.name);
  return html`<span class="clip-label" title=${name}
    >${grouped ? nothing : labelMark(label.index)}<span class="spoken">${name}</span></span
  >`;
}

/** A number that is seen, and the words with it that are spoken and shown by its tip. */
const counted = (number: string, words: string): TemplateResult =>
  html`<span aria-hidden="true">${number}</span><span class="spoken"> ${words}</span>`;

function counts({ words: { t, format }, clip }: RowProps): TemplateResult {
  const notes = clip.result ? notesOf(clip.result) : [];
  const warnings = warningsAmong(notes);
  const keyposes = keyposeCount(clip);
  const about = warnings > 0 ? t('notes.warnings', warnings) : t('library.notes', notes.length);
  return html`<span class="clip-counts">
    ${
      isAnalysed(clip)
        ? html`<span class="count" title=${t('library.keyposes', keyposes)}
            ><i class="keypose-dot"></i
            >${counted(format.integer(keyposes), t('library.keyposes', keyposes))}</span
          >`
        : nothing
    }
    ${
      notes.length > 0
        ? html`<span class="badge ${warnings > 0 ? 'warning' : ''}" title=${about}
            >${icon(warnings > 0 ? 'triangle-alert' : 'info', 12)}${counted(format.integer(warnings || notes.length), about)}</span
          >`
        : nothing
    }
  </span>`;
}

function tick({ words }: RowProps): TemplateResult {
  return html`<span class="clip-tick"
    >${icon('check', 11)}<span class="spoken">${words.t('library.ticked.one')}</span></span
  >`;
}

function removal({ words, clip, onRemove }: RowProps): TemplateResult {
  return html`<span class="clip-remove"
    >${iconButton({
      name: 'x',
      label: words.t('library.remove', clip.source.name),
      size: 14,
      small: true,
      keys: 'Delete',
      keyText: words.t('key.delete'),
      onPress: onRemove,
    })}</span
  >`;
}

export function libraryRow(props: RowProps): TemplateResult {
  const { clip, open, index, count } = props;
  const states = { open, other: props.other, ticked: props.ticked, outdated: clip.outdated };
  const on = Object.entries(states).flatMap(([name, holds]) => (holds ? [name] : []));
  return html`<li
    class="clip ${clip.status} ${on.join(' ')}"
    aria-setsize=${count}
    aria-posinset=${index + 1}
    ${styled({ transform: `translateY(${props.top}px)` })}
  >
    <button
      type="button"
      class="clip-open"
      data-clip=${clip.id}
      data-space="plays"
      aria-current=${open ? 'true' : nothing}
      tabindex=${props.tabStop ? 0 : -1}
      @click=${props.onPress}
    >
      ${thumbnail(props)} ${props.ticked ? tick(props) : nothing}
      <span class="clip-text"
        >${clipName(clip.source.name, props.qualifier)}<span class="clip-beneath"
          >${labelOf(props)}${facts(props)}</span
        ></span
      >
      ${counts(props)}
    </button>
    ${removal(props)}
  </li>`;
}
