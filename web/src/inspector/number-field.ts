/** A field for a number: what is written in; the number, or the sentence that refuses it, out. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { drawn } from '../common/directives';
import { parseNumber, stepped } from './parameter-values';
import type { Refusals } from './refusals';
import { wrongId } from './setting-row';

export interface NumberSetting {
  readonly id: string;
  /** Where no label of its own stands beside it. */
  readonly label?: string;
  readonly value: number;
  /** Whatever changes what the field shows, or what it may hold. */
  readonly basis: string;
  readonly unit: string;
  /** By an arrow key; ten times with Shift. */
  readonly step: number;
  /** Why a number cannot be taken; null if it can. */
  readonly refuse: (value: number) => string | null;
  readonly onValue: (value: number) => void;
  readonly narrow?: boolean;
  /** The element that says what was wrong, if it is not the field's own. */
  readonly wrongId?: string;
}

const shiftFactor = 10;

function take(
  input: HTMLInputElement,
  text: string,
  setting: NumberSetting,
  refusals: Refusals,
  words: Words,
): void {
  const value = parseNumber(text);
  const wrong = Number.isNaN(value) ? words.t('wrong.number') : setting.refuse(value);
  input.value = wrong === null ? String(value) : text;
  input.setCustomValidity(wrong ?? '');
  refusals.set(setting.id, setting.basis, wrong);
  if (wrong === null && value !== setting.value) setting.onValue(value);
}

type Take = (event: Event, text: (input: HTMLInputElement) => string) => void;

function stepOnKey({ value, step }: NumberSetting, takeFrom: Take): (event: KeyboardEvent) => void {
  return (event) => {
    const direction = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (!direction) return;
    event.preventDefault();
    const by = direction * step * (event.shiftKey ? shiftFactor : 1);
    takeFrom(event, (input) => {
      const written = parseNumber(input.value);
      return String(stepped(Number.isNaN(written) ? value : written, by));
    });
  };
}

/** Whatever was written before, a refused number too, belongs to another clip or another result. */
const show =
  (value: number) =>
  (element: Element): void => {
    const input = element as HTMLInputElement;
    input.defaultValue = input.value = String(value);
    input.setCustomValidity('');
  };

export function numberField(
  words: Words,
  setting: NumberSetting,
  refusals: Refusals,
): TemplateResult {
  const { id, label, value, basis, unit, narrow } = setting;
  const takeFrom: Take = (event, text) => {
    const input = event.target as HTMLInputElement;
    take(input, text(input), setting, refusals, words);
  };
  const wrong = refusals.of(id, basis) !== null;
  return html`<span class="value ${narrow ? 'narrow' : ''}">
    <input
      id=${id}
      type="text"
      inputmode="decimal"
      autocomplete="off"
      aria-label=${label ?? nothing}
      aria-invalid=${wrong ? 'true' : nothing}
      aria-describedby=${wrong ? (setting.wrongId ?? wrongId(id)) : nothing}
      @change=${(event: Event) => takeFrom(event, (input) => input.value)}
      @keydown=${stepOnKey(setting, takeFrom)}
      ${drawn(basis, show(value))}
    />
    ${unit ? html`<span class="value-unit">${unit}</span>` : nothing}
  </span>`;
}
