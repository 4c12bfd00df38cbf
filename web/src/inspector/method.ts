/** How keyposes are found: the method's name, and every parameter with its default and its way back. */
import { html, type TemplateResult } from 'lit-html';
import type { OptionKey } from '../app/option-changes';
import type { MessageKey, Words } from '../app/i18n/catalogue';
import { icon } from '../common/icons';
import type { MethodOptions, MethodSettings } from '../engine/types';
import { numberField } from './number-field';
import { refusalOf, scaleCount, type NumberKey, type Refusal } from './parameter-values';
import type { Refusals } from './refusals';
import { section } from './section';
import { choiceField, settingRow, wrongId } from './setting-row';

export interface MethodProps {
  readonly words: Words;
  readonly options: MethodOptions;
  readonly defaults: MethodSettings;
  readonly refusals: Refusals;
  readonly onOption: <Key extends OptionKey>(
    key: Key,
    value: MethodOptions[Key] | undefined,
  ) => void;
  readonly onReset: (keys?: readonly OptionKey[]) => void;
}

interface Parameter {
  readonly id: string;
  readonly label: MessageKey;
  readonly unit: 'unit.hz' | null;
  readonly step: number;
}

const parameters: Readonly<Record<NumberKey, Parameter>> = {
  lowPassHz: { id: 'low-pass', label: 'parameter.low-pass', unit: 'unit.hz', step: 1 },
  scaleMaxHz: { id: 'scale-max', label: 'parameter.scale-max', unit: null, step: 1 },
  scaleMinHz: { id: 'scale-min', label: 'parameter.scale-min', unit: 'unit.hz', step: 0.1 },
  scaleRatio: { id: 'scale-ratio', label: 'parameter.ratio', unit: null, step: 0.01 },
};

const rangeWrongId = wrongId(parameters.scaleMaxHz.id);
const rules = ['automatic', 'literal', 'even-split'] as const;

const settingsOf = ({ options, defaults }: MethodProps): MethodSettings => ({
  ...defaults,
  ...options,
});
const basisOf = (props: MethodProps): string => JSON.stringify(settingsOf(props));

const wrongIn = (props: MethodProps, key: NumberKey): string | null =>
  props.refusals.of(parameters[key].id, basisOf(props));

const refusalText = ({ t, format }: Words, refusal: Refusal | null): string | null =>
  refusal && t(refusal.key, ...refusal.values.map((one) => format.short(one, 6)));

const refuse = (props: MethodProps, key: NumberKey, value: number): string | null =>
  refusalText(props.words, refusalOf({ ...settingsOf(props), [key]: value }, key));

function field(props: MethodProps, key: NumberKey): TemplateResult {
  const { words, refusals, onOption } = props;
  const { id, unit, step, label } = parameters[key];
  const inRange = key === 'scaleMaxHz' || key === 'scaleMinHz';
  const setting = {
    id,
    value: settingsOf(props)[key],
    basis: basisOf(props),
    unit: unit ? words.t(unit) : '',
    step,
    narrow: inRange,
    refuse: (value: number) => refuse(props, key, value),
    onValue: (value: number) => onOption(key, value),
  };
  const beside = inRange ? { label: words.t(label), wrongId: rangeWrongId } : {};
  return numberField(words, { ...setting, ...beside }, refusals);
}

/** Back to the defaults, unless another parameter forbids it: then the field says why. */
function resetTo(props: MethodProps, keys: readonly NumberKey[]): void {
  const { words, defaults, refusals, onReset } = props;
  const usual = Object.fromEntries(keys.map((key) => [key, defaults[key]]));
  const wrong = keys.map((key) =>
    refusalText(words, refusalOf({ ...settingsOf(props), ...usual }, key)),
  );
  keys.forEach((key, index) =>
    refusals.set(parameters[key].id, basisOf(props), wrong[index] ?? null),
  );
  if (wrong.every((sentence) => sentence === null)) onReset(keys);
}

function resetOf(props: MethodProps, label: string, keys: readonly NumberKey[]) {
  const { t, format } = props.words;
  if (keys.every((key) => props.options[key] === undefined)) return null;
  const values = keys.map((key) => format.short(props.defaults[key], 6)).join('–');
  return { label: t('parameter.reset', label, values), onPress: () => resetTo(props, keys) };
}

function numberRow(props: MethodProps, key: NumberKey, label: string): TemplateResult {
  return settingRow({
    id: parameters[key].id,
    label,
    reset: resetOf(props, props.words.t(parameters[key].label), [key]),
    control: field(props, key),
    wrong: wrongIn(props, key),
  });
}

function rangeRow(props: MethodProps): TemplateResult {
  const label = props.words.t('parameter.scales');
  return settingRow({
    id: parameters.scaleMaxHz.id,
    label,
    plainLabel: true,
    reset: resetOf(props, label, ['scaleMaxHz', 'scaleMinHz']),
    control: html`<span class="value-pair" role="group" aria-label=${label}
      >${field(props, 'scaleMaxHz')}${field(props, 'scaleMinHz')}</span
    >`,
    wrong: [wrongIn(props, 'scaleMaxHz'), wrongIn(props, 'scaleMinHz')].filter(Boolean).join(' '),
  });
}

function selectionRow(props: MethodProps): TemplateResult {
  const { t } = props.words;
  const { options, defaults, onOption } = props;
  const label = t('parameter.selection');
  const usual = t(`selection.${defaults.selection}`);
  const reset = {
    label: t('parameter.reset', label, usual),
    onPress: () => onOption('selection', undefined),
  };
  return settingRow({
    id: 'selection',
    label,
    reset: options.selection === undefined ? null : reset,
    control: choiceField({
      id: 'selection',
      value: settingsOf(props).selection,
      options: rules.map((rule) => [rule, t(`selection.${rule}`)]),
      onValue: (value) =>
        onOption(
          'selection',
          rules.find((rule) => rule === value),
        ),
    }),
  });
}

export function methodSection(props: MethodProps): TemplateResult {
  const { words, options, onReset } = props;
  const { t } = words;
  const ratio = t('parameter.ratio.scales', scaleCount(settingsOf(props)));
  const unchanged = Object.keys(options).length === 0;
  return section({
    label: t('method.title'),
    beside: html`<button
      type="button"
      class="link-button"
      ?disabled=${unchanged}
      @click=${() => onReset()}
    >
      ${t('method.reset')}
    </button>`,
    body: html`<p class="method-name">
        ${icon('waypoints', 15)}<span>${t('method.time-scales')}</span
        ><span class="source">${t('method.source')}</span>
      </p>
      ${numberRow(props, 'lowPassHz', t('parameter.low-pass'))} ${rangeRow(props)}
      ${numberRow(props, 'scaleRatio', ratio)} ${selectionRow(props)}`,
  });
}
