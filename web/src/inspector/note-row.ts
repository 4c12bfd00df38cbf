/** A departure from the plain form of a file: what, where, what was assumed, and how to overrule it. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Clip } from '../app/clips';
import type { Words } from '../app/i18n/catalogue';
import { isWarning } from '../app/notes';
import type { InspectorTab } from '../app/store';
import { icon } from '../common/icons';
import type { Note, PerformerResult } from '../engine/types';
import { settingIds } from './clip-settings';

export interface NoteProps {
  readonly words: Words;
  readonly clip: Clip;
  readonly performer: PerformerResult;
  readonly onFrame: (frame: number) => void;
  /** Takes leading frames out, as found, or leaves them in. */
  readonly onLeaveOut: (leaveOut: boolean) => void;
  readonly onField: (tab: InspectorTab, id: string) => void;
}

interface FieldLink {
  readonly tab: InspectorTab;
  readonly id: string;
  readonly label: 'recording.rate' | 'recording.up' | 'recording.unit' | 'body.joints.title';
}

const rateLink: FieldLink = { tab: 'doctor', id: settingIds.frameRateHz, label: 'recording.rate' };
const jointsLink: FieldLink = {
  tab: 'body',
  id: 'joint-left_shoulder',
  label: 'body.joints.title',
};

/** Where the assumption of a kind of note can be overruled. */
const links: Readonly<Record<string, FieldLink>> = {
  'frame-time-missing': rateLink,
  'frame-time-invalid': rateLink,
  'frame-time-is-rate': rateLink,
  'frame-time-is-milliseconds': rateLink,
  'frame-time-is-seconds': rateLink,
  'up-assumed': { tab: 'body', id: settingIds.up, label: 'recording.up' },
  'unit-unknown': { tab: 'body', id: settingIds.unit, label: 'recording.unit' },
  mirrored: jointsLink,
  'end-effector-fallback': jointsLink,
  'end-sites-unequal': jointsLink,
  'shifted-arm-names': jointsLink,
  'shifted-leg-names': jointsLink,
};

function placeText({ t }: Words, { line, column }: Note): string {
  if (line === null) return '';
  return column === null
    ? t('notes.line', String(line))
    : t('notes.place', String(line), String(column));
}

function leadingSwitch({ words: { t }, clip, performer, onLeaveOut }: NoteProps): TemplateResult {
  const leftOut = (clip.decisions.leadingRestFrames ?? performer.leadingRestFrames) > 0;
  return html`<button
    type="button"
    class="switch"
    role="switch"
    aria-checked=${String(leftOut)}
    aria-label=${t('notes.leave-out')}
    data-tip=${t('notes.leave-out')}
    @click=${() => onLeaveOut(!leftOut)}
  ></button>`;
}

function frameButton({ words: { t }, onFrame }: NoteProps, frame: number): TemplateResult {
  return html`<button type="button" class="link-button" @click=${() => onFrame(frame)}>
    ${t('notes.frame', String(frame))}
  </button>`;
}

function fieldButton(
  { words: { t }, onField }: NoteProps,
  { tab, id, label }: FieldLink,
): TemplateResult {
  return html`<button type="button" class="link-button" @click=${() => onField(tab, id)}>
    ${t(label)}${icon('chevron-right', 12)}
  </button>`;
}

export function noteRow(props: NoteProps, note: Note): TemplateResult {
  const { words, performer } = props;
  const { what, assumed } = words.noteParts(note);
  const warning = isWarning(note);
  const human = performer.body.kind === 'human';
  const link = links[note.kind] === jointsLink && !human ? undefined : links[note.kind];
  const place = placeText(words, note);
  const kind = words.t(warning ? 'notes.warning' : 'notes.remark');
  return html`<li class="note ${warning ? 'warning' : ''}">
    ${icon(warning ? 'triangle-alert' : 'info', 15)}<span class="spoken">${kind}</span>
    <div class="note-text">
      <p class="note-what">${what}</p>
      <p class="note-more">
        ${place ? html`<span class="note-place">${place}</span> ` : nothing}${assumed ? html`<span class="note-assumed">${assumed}</span> ` : nothing}
        ${note.frame === null ? nothing : frameButton(props, note.frame)}
        ${link ? fieldButton(props, link) : nothing}
      </p>
    </div>
    ${note.kind.startsWith('leading-') ? leadingSwitch(props) : nothing}
  </li>`;
}
