/** Clips that are ticked in; how many, and what can be done with all of them, out. */
import { html, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { iconButton } from '../common/buttons';

export interface TickedBarProps {
  readonly words: Words;
  readonly count: number;
  /** '' takes the labels away. */
  readonly onLabel: (label: string) => void;
  readonly onRemove: () => void;
  readonly onClear: () => void;
}

export function tickedBar(props: TickedBarProps): TemplateResult {
  const { t } = props.words;
  const onSubmit = (event: Event): void => {
    event.preventDefault();
    const field = (event.target as HTMLFormElement).querySelector('input');
    props.onLabel(field?.value.trim() ?? '');
    if (field) field.value = '';
  };
  return html`<div
    class="library-ticked"
    role="group"
    aria-label=${t('library.ticked', props.count)}
  >
    <div>
      <span role="status">${t('library.ticked', props.count)}</span>
      <button type="button" class="button ghost" @click=${props.onRemove}>
        ${t('library.ticked.remove')}
      </button>
      ${iconButton({ name: 'x', label: t('library.ticked.clear'), size: 14, small: true, keys: 'Escape', keyText: 'Esc', onPress: props.onClear })}
    </div>
    <form @submit=${onSubmit}>
      <div class="field">
        <input
          type="text"
          autocomplete="off"
          aria-label=${t('library.ticked.label')}
          placeholder=${t('library.ticked.label')}
        />
      </div>
      <button type="submit" class="button line">${t('library.ticked.set')}</button>
    </form>
  </div>`;
}
