/** The head of the clips of one label: folds them away, and gives the label another name. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { iconButton } from '../common/buttons';
import { styled } from '../common/directives';
import { icon } from '../common/icons';
import { labelMark } from '../common/label-mark';
import type { GroupEntry } from './entries';

export interface GroupHeadProps {
  readonly words: Words;
  readonly group: GroupEntry;
  /** Place of its label among all. */
  readonly place: number;
  readonly top: number;
  /** It holds the open clip. */
  readonly open: boolean;
  /** Its name is being written. */
  readonly renaming: boolean;
  readonly onFold: (folded: boolean) => void;
  readonly onRename: () => void;
  /** null: it keeps its name. */
  readonly onRenamed: (name: string | null) => void;
}

function nameField({ words: { t }, group, onRenamed }: GroupHeadProps): TemplateResult {
  const label = group.label ?? '';
  const onKey = (event: KeyboardEvent): void => {
    event.stopPropagation();
    if (event.isComposing) return;
    if (event.key === 'Enter') onRenamed((event.target as HTMLInputElement).value.trim());
    if (event.key === 'Escape') onRenamed(null);
    if (event.key === 'Enter' || event.key === 'Escape') event.preventDefault();
  };
  return html`<input
    class="group-name-field"
    type="text"
    autocomplete="off"
    spellcheck="false"
    aria-label=${t('library.new-name', label)}
    .value=${label}
    @keydown=${onKey}
    @blur=${(event: Event) => onRenamed((event.target as HTMLInputElement).value.trim())}
  />`;
}

function toggle(props: GroupHeadProps): TemplateResult {
  const { words, group, place, onFold, onRename } = props;
  const { label, folded } = group;
  const onKey = (event: KeyboardEvent): void => {
    if (event.key === 'F2' && label !== null) onRename();
    else if (event.key === 'ArrowRight') onFold(false);
    else if (event.key === 'ArrowLeft') onFold(true);
    else return;
    event.preventDefault();
  };
  return html`<button
    type="button"
    class="group-toggle"
    data-group=${label ?? ''}
    tabindex="-1"
    aria-expanded=${String(!folded)}
    @click=${() => onFold(!folded)}
    @dblclick=${label === null ? nothing : onRename}
    @keydown=${onKey}
  >
    ${icon(folded ? 'chevron-right' : 'chevron-down', 14)}${labelMark(place)}<span
      class="group-name"
      >${label ?? words.t('library.no-label')}</span
    >
  </button>`;
}

export function groupHead(props: GroupHeadProps): TemplateResult {
  const { words, group, open, top, renaming, onRename } = props;
  const { label, count } = group;
  return html`<li
    class="group ${open ? 'holds-open' : ''}"
    ${styled({ transform: `translateY(${top}px)` })}
  >
    ${renaming ? nameField(props) : toggle(props)}
    ${
      label === null || renaming
        ? nothing
        : html`<span class="group-rename"
            >${iconButton({ name: 'pencil', label: words.t('library.rename', label), size: 12, small: true, keys: 'F2', keyText: 'F2', onPress: onRename })}</span
          >`
    }
    <span class="group-count">${words.format.integer(count)}</span>
  </li>`;
}
