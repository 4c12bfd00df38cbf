/** One line of a form of the side panel: label, way back to what is usual, control; below it, what was wrong. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { iconButton } from '../common/buttons';

export interface SettingRow {
  /** Of the control that the label names. */
  readonly id: string;
  readonly label: string;
  /** Given where the value is the person's own: the button that takes it back. */
  readonly reset: { readonly label: string; readonly onPress: () => void } | null;
  readonly control: TemplateResult;
  /** Given where the control is more than the one field that the label names. */
  readonly plainLabel?: boolean;
  readonly wrong?: string | null;
}

export const wrongId = (id: string): string => `${id}-wrong`;

function resetButton({ id, reset }: SettingRow): TemplateResult | typeof nothing {
  if (!reset) return nothing;
  return iconButton({
    name: 'reset',
    label: reset.label,
    size: 13,
    small: true,
    onPress() {
      reset.onPress();
      // The button goes; the focus stays with its field.
      document.getElementById(id)?.focus();
    },
  });
}

export function settingRow(row: SettingRow): TemplateResult {
  const { id, label, reset, control, plainLabel, wrong } = row;
  return html`<div class="setting ${reset ? 'changed' : ''}">
      ${plainLabel ? html`<span class="setting-label">${label}</span>` : html`<label class="setting-label" for=${id}>${label}</label>`}
      ${resetButton(row)} ${control}
    </div>
    <p id=${wrongId(id)} class="wrong" role="alert" ?hidden=${!wrong}>${wrong ?? nothing}</p>`;
}

export interface Choice {
  readonly id: string;
  readonly value: string;
  readonly options: readonly (readonly [value: string, name: string])[];
  readonly onValue: (value: string) => void;
}

export function choiceField({ id, value, options, onValue }: Choice): TemplateResult {
  const onChange = (event: Event): void => onValue((event.target as HTMLSelectElement).value);
  return html`<span class="value select"
    ><select id=${id} .value=${value} @change=${onChange}>
      ${options.map(([one, name]) => html`<option value=${one} ?selected=${one === value}>${name}</option>`)}
    </select></span
  >`;
}
