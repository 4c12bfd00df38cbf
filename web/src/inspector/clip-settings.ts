/** What a person can say of a recording instead of what was found: rate, leading frames, up axis, unit, ground. */
import type { TemplateResult } from 'lit-html';
import type { Clip } from '../app/clips';
import type { DecisionKey } from '../app/decisions';
import type { MessageKey, Words } from '../app/i18n/catalogue';
import type { ClipResult, Decisions, PerformerResult, UnitName, UpAxis } from '../engine/types';
import { numberField } from './number-field';
import type { Refusals } from './refusals';
import { choiceField, settingRow } from './setting-row';

export interface ClipSettingsProps {
  readonly words: Words;
  readonly clip: Clip;
  readonly result: ClipResult;
  readonly performer: PerformerResult;
  readonly refusals: Refusals;
  readonly onDecide: (key: DecisionKey, value: Decisions[DecisionKey] | undefined) => void;
}

type SettingKey = Exclude<DecisionKey, 'joints'>;

/** Ids of the controls, to which notes lead. */
export const settingIds: Readonly<Record<SettingKey, string>> = {
  frameRateHz: 'frame-rate',
  leadingRestFrames: 'leading-frames',
  up: 'up-axis',
  unit: 'unit',
  groundHeight: 'ground',
};

const axes: readonly UpAxis[] = ['+X', '-X', '+Y', '-Y', '+Z', '-Z'];
const units: readonly UnitName[] = ['m', 'dm', 'cmu', 'inch', 'cm', 'mm'];
const leastRateHz = 0.25;
const mostRateHz = 2000;

/** −X with a real minus. */
const axisName = (axis: UpAxis): string => axis.replace('-', '−');

function resetOf({ words, clip, onDecide }: ClipSettingsProps, key: SettingKey, label: string) {
  if (clip.decisions[key] === undefined) return null;
  return {
    label: words.t('recording.reset', label),
    onPress: () => onDecide(key, undefined),
  };
}

interface NumberRow {
  readonly key: 'frameRateHz' | 'leadingRestFrames' | 'groundHeight';
  readonly label: MessageKey;
  readonly found: number;
  readonly unit: string;
  readonly step?: number;
  readonly refuse: (value: number) => string | null;
}

function numberRow(props: ClipSettingsProps, row: NumberRow): TemplateResult {
  const { words, clip, refusals, onDecide } = props;
  const { key, found, unit, step = 1, refuse } = row;
  const id = settingIds[key];
  const label = words.t(row.label);
  const value = clip.decisions[key] ?? found;
  const basis = `${clip.id} ${value}`;
  const onValue = (decided: number): void => onDecide(key, decided);
  const setting = { id, value, basis, unit, step, refuse, onValue };
  return settingRow({
    id,
    label,
    reset: resetOf(props, key, label),
    control: numberField(words, setting, refusals),
    wrong: refusals.of(id, basis),
  });
}

export function rateRow(props: ClipSettingsProps): TemplateResult {
  const { t } = props.words;
  return numberRow(props, {
    key: 'frameRateHz',
    label: 'recording.rate',
    // As files write it: eight or so digits of 1/120 give 120.0005.
    found: Math.round(100 / props.result.frameTimeS) / 100,
    unit: t('unit.hz'),
    refuse: (hz) => (hz >= leastRateHz && hz <= mostRateHz ? null : t('recording.rate.range')),
  });
}

export function leadingFramesRow(props: ClipSettingsProps): TemplateResult {
  const { t } = props.words;
  const { result, performer } = props;
  const fits = (count: number): boolean =>
    Number.isInteger(count) && count >= 0 && count <= Math.max(0, result.frames - 1);
  return numberRow(props, {
    key: 'leadingRestFrames',
    label: 'recording.rest',
    found: performer.leadingRestFrames,
    unit: '',
    refuse: (count) => (fits(count) ? null : t('recording.rest.range')),
  });
}

interface ChoiceRow {
  readonly key: 'up' | 'unit';
  readonly label: MessageKey;
  readonly found: string;
  readonly options: readonly (readonly [string, string])[];
}

function choiceRow(props: ClipSettingsProps, row: ChoiceRow): TemplateResult {
  const { words, clip, onDecide } = props;
  const { key, found, options } = row;
  const { t } = words;
  const label = t(row.label);
  const chosen = clip.decisions[key] ?? '';
  const automatic = chosen === '' ? t('recording.automatic.is', found) : t('recording.automatic');
  const onValue = (value: string): void =>
    onDecide(key, value === '' ? undefined : (value as UpAxis | UnitName));
  const choice = {
    id: settingIds[key],
    value: chosen,
    options: [['', automatic] as const, ...options],
    onValue,
  };
  return settingRow({
    id: settingIds[key],
    label,
    reset: resetOf(props, key, label),
    control: choiceField(choice),
  });
}

export function upAxisRow(props: ClipSettingsProps): TemplateResult {
  return choiceRow(props, {
    key: 'up',
    label: 'recording.up',
    found: axisName(props.performer.up.axis),
    options: axes.map((axis) => [axis, axisName(axis)]),
  });
}

export function unitRow(props: ClipSettingsProps): TemplateResult {
  const { t } = props.words;
  const { unit } = props.performer;
  return choiceRow(props, {
    key: 'unit',
    label: 'recording.unit',
    found: unit ? t(`unit.${unit.name}`) : t('recording.unit.unknown'),
    options: units.map((name) => [name, t(`unit.${name}`)]),
  });
}

/** Digits enough to tell bodies apart in any unit. */
export const digitsFor = (value: number): number =>
  Math.abs(value) >= 100 ? 1 : Math.abs(value) >= 10 ? 2 : 3;

/** A step is about a centimetre of a person. */
export function groundRow(props: ClipSettingsProps): TemplateResult {
  const { t } = props.words;
  const { body, groundHeight } = props.performer;
  return numberRow(props, {
    key: 'groundHeight',
    label: 'recording.ground',
    found: Number(groundHeight.toFixed(digitsFor(groundHeight))),
    unit: t('recording.units'),
    step: body.height > 0 ? 10 ** Math.round(Math.log10(body.height / 150)) : 1,
    refuse: (height) => (Number.isFinite(height) ? null : t('wrong.number')),
  });
}
