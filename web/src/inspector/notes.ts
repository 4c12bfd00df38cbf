/** Every departure from the plain form of a file: where, what, and what was assumed. */
import { html, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { isWarning } from '../app/notes';
import { icon } from '../common/icons';
import type { Note } from '../engine/types';
import { section } from './section';

function placeOf({ t }: Words, { line, column, frame }: Note): string {
  const inFile =
    line === null
      ? ''
      : column === null
        ? t('notes.line', String(line))
        : t('notes.place', String(line), String(column));
  const inMotion = frame === null ? '' : t('notes.frame', String(frame));
  return [inFile, inMotion].filter(Boolean).join(', ');
}

function noteRow(words: Words, note: Note, onFrame: (frame: number) => void): TemplateResult {
  const { frame } = note;
  const place = placeOf(words, note);
  const where =
    frame === null || !place
      ? html`<span class="note-place">${place}</span>`
      : html`<button type="button" class="note-place link" @click=${() => onFrame(frame)}>
          ${place}
        </button>`;
  return html`<li class="note ${isWarning(note) ? 'warning' : ''}">
    ${icon(isWarning(note) ? 'triangle-alert' : 'info', 14)}
    <div>
      ${where}
      <p>${words.note(note)}</p>
    </div>
  </li>`;
}

export function notesSection(
  words: Words,
  notes: readonly Note[],
  onFrame: (frame: number) => void,
): TemplateResult {
  const sorted = [...notes].sort((a, b) => Number(isWarning(b)) - Number(isWarning(a)));
  const body =
    notes.length === 0
      ? html`<p class="quiet">${words.t('notes.none')}</p>`
      : html`<ul class="notes">
          ${sorted.map((note) => noteRow(words, note, onFrame))}
        </ul>`;
  return section(
    words.t('notes.title'),
    notes.length === 0 ? '' : words.format.integer(notes.length),
    body,
  );
}
