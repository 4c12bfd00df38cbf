/** What the file is, and every departure from its plain form, warnings first. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { lengthOf } from '../app/clips';
import type { Words } from '../app/i18n/catalogue';
import { isWarning, warningsAmong } from '../app/notes';
import { lengthText } from '../library/row';
import type { Note } from '../engine/types';
import { leadingFramesRow, rateRow, type ClipSettingsProps } from './clip-settings';
import { noteRow, type NoteProps } from './note-row';
import { fact, section } from './section';

export interface DoctorProps extends ClipSettingsProps, NoteProps {
  readonly notes: readonly Note[];
  /** How many of them are shown at most. */
  readonly limit: number;
  readonly onMore: () => void;
}

export const notesAtOnce = 100;

function recordingSection(props: DoctorProps): TemplateResult {
  const { words, clip, result } = props;
  const { t, format } = words;
  const frames = html`${format.integer(result.frames)} · ${lengthText(words, lengthOf(result))}`;
  const { folder } = clip.source;
  const facts = html`<dl class="facts">
    ${folder ? fact(t('recording.folder'), html`<span title=${folder}>${folder}</span>`) : nothing}
    ${fact(t('recording.frames'), frames)}
  </dl>`;
  return section({
    label: t('recording.title'),
    beside: format.bytes(clip.source.blob.size),
    body: html`${facts}${rateRow(props)}${leadingFramesRow(props)}`,
  });
}

function countText({ t }: Words, notes: readonly Note[]): string {
  const warnings = warningsAmong(notes);
  const remarks = notes.length - warnings;
  const texts = [
    warnings > 0 ? t('notes.warnings', warnings) : '',
    remarks > 0 ? t('notes.remarks', remarks) : '',
  ];
  return texts.filter(Boolean).join(t('join.list'));
}

function noteList(props: DoctorProps): TemplateResult {
  const { words, notes, limit, onMore } = props;
  const sorted = [...notes].sort((a, b) => Number(isWarning(b)) - Number(isWarning(a)));
  const left = notes.length - limit;
  const more = html`<button type="button" class="button line wide" @click=${onMore}>
    ${words.t('notes.more', Math.min(left, notesAtOnce), words.format.integer(notes.length))}
  </button>`;
  return html`<ul class="notes">
      ${sorted.slice(0, limit).map((note) => noteRow(props, note))}
    </ul>
    ${left > 0 ? more : nothing}`;
}

export function doctor(props: DoctorProps): TemplateResult {
  const { words, notes, clip } = props;
  const body =
    notes.length === 0 ? html`<p class="quiet">${words.t('notes.none')}</p>` : noteList(props);
  return html`${recordingSection(props)}
  ${section({ label: words.t('notes.title'), beside: countText(words, notes), body, outdated: clip.outdated })}`;
}
