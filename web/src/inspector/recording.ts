/** What the file says of itself, and what a person can say instead. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { lengthOf, type Clip } from '../app/clips';
import type { DecisionKey } from '../app/decisions';
import type { Words } from '../app/i18n/catalogue';
import { iconButton } from '../common/buttons';
import { drawn } from '../common/directives';
import { lengthText } from '../library/row';
import type { ClipResult, Decisions, PerformerResult, UnitName, UpAxis } from '../engine/types';
import { fact, section } from './section';

export interface RecordingProps {
  readonly words: Words;
  readonly clip: Clip;
  readonly result: ClipResult;
  readonly performer: PerformerResult;
  readonly performerIndex: number;
  readonly onDecide: (key: DecisionKey, value: Decisions[DecisionKey] | undefined) => void;
  readonly onPerformer: (index: number) => void;
}

const axes: readonly UpAxis[] = ['+X', '-X', '+Y', '-Y', '+Z', '-Z'];
const units: readonly UnitName[] = ['m', 'dm', 'cmu', 'inch', 'cm', 'mm'];

/** −X with a real minus. */
const axisName = (axis: UpAxis): string => axis.replace('-', '−');

function row(
  props: RecordingProps,
  key: DecisionKey,
  label: string,
  control: TemplateResult,
): TemplateResult {
  const changed = props.clip.decisions[key] !== undefined;
  return html`<div class="override ${changed ? 'changed' : ''}">
    <label for=${`override-${key}`}>${label}</label>
    ${
      changed
        ? iconButton({
            name: 'reset',
            label: props.words.t('recording.reset', label),
            size: 13,
            small: true,
            onPress: () => props.onDecide(key, undefined),
          })
        : nothing
    }
    ${control}
  </div>`;
}

interface NumberField {
  readonly key: 'frameRateHz' | 'leadingRestFrames';
  readonly value: number;
  readonly least: number;
  readonly most: number;
  readonly step: string;
  readonly unit: string;
  readonly wrong: string;
}

function numberField({ clip, onDecide }: RecordingProps, field: NumberField): TemplateResult {
  const onChange = (event: Event): void => {
    const input = event.target as HTMLInputElement;
    input.setCustomValidity('');
    const valid = input.value !== '' && input.checkValidity();
    input.setCustomValidity(valid ? '' : field.wrong);
    if (valid) onDecide(field.key, input.valueAsNumber);
    else input.reportValidity();
  };
  // Whatever was written before, a refused number too, belongs to another clip or another result.
  const show = (element: Element): void => {
    const input = element as HTMLInputElement;
    input.value = String(field.value);
    input.setCustomValidity('');
  };
  return html`<span class="value">
    <input
      id=${`override-${field.key}`}
      type="number"
      min=${field.least}
      max=${field.most}
      step=${field.step}
      @change=${onChange}
      ${drawn(`${clip.id} ${field.value}`, show)}
    />
    ${field.unit ? html`<span class="value-unit">${field.unit}</span>` : nothing}
  </span>`;
}

interface Choice {
  readonly key: 'up' | 'unit';
  readonly found: string | null;
  readonly options: readonly (readonly [string, string])[];
}

function choice(
  { words: { t }, clip, onDecide }: RecordingProps,
  { key, found, options }: Choice,
): TemplateResult {
  const chosen = clip.decisions[key] ?? '';
  const automatic =
    chosen === '' && found ? t('recording.automatic.is', found) : t('recording.automatic');
  const onChange = (event: Event): void => {
    const { value } = event.target as HTMLSelectElement;
    onDecide(key, value === '' ? undefined : (value as UpAxis | UnitName));
  };
  return html`<span class="value select"
    ><select id=${`override-${key}`} .value=${chosen} @change=${onChange}>
      <option value="" ?selected=${chosen === ''}>${automatic}</option>
      ${options.map(([value, name]) => html`<option value=${value} ?selected=${value === chosen}>${name}</option>`)}
    </select></span
  >`;
}

function rateField(props: RecordingProps): TemplateResult {
  const { t } = props.words;
  const { frameTimeS } = props.result;
  // As files write it: eight or so digits of 1/120 give 120.0005.
  const value = Math.round(100 / frameTimeS) / 100;
  return numberField(props, {
    key: 'frameRateHz',
    value,
    least: 0.25,
    most: 2000,
    step: 'any',
    unit: 'Hz',
    wrong: t('recording.rate.range'),
  });
}

function restField(props: RecordingProps): TemplateResult {
  const most = Math.max(0, props.result.frames - 1);
  const value = props.performer.leadingRestFrames;
  return numberField(props, {
    key: 'leadingRestFrames',
    value,
    least: 0,
    most,
    step: '1',
    unit: '',
    wrong: props.words.t('recording.rest.range'),
  });
}

function overrides(props: RecordingProps): TemplateResult {
  const { t } = props.words;
  const { up, unit } = props.performer;
  return html`
    ${row(props, 'frameRateHz', t('recording.rate'), rateField(props))}
    ${row(props, 'leadingRestFrames', t('recording.rest'), restField(props))}
    ${row(props, 'up', t('recording.up'), choice(props, { key: 'up', found: axisName(up.axis), options: axes.map((axis) => [axis, axisName(axis)]) }))}
    ${row(props, 'unit', t('recording.unit'), choice(props, { key: 'unit', found: unit ? t(`unit.${unit.name}`) : t('recording.unit.unknown'), options: units.map((name) => [name, t(`unit.${name}`)]) }))}
  `;
}

function performers({
  words: { t },
  result,
  performerIndex,
  onPerformer,
}: RecordingProps): TemplateResult | typeof nothing {
  if (result.performers.length < 2) return nothing;
  const onChange = (event: Event): void =>
    onPerformer(Number((event.target as HTMLSelectElement).value));
  const option = (_: unknown, index: number): TemplateResult =>
    html`<option value=${index} ?selected=${index === performerIndex}>
      ${t('recording.performer.number', index + 1)}
    </option>`;
  return html`<div class="override">
    <label for="performer">${t('recording.performer')}</label>
    <span class="value select"
      ><select id="performer" @change=${onChange}>
        ${result.performers.map(option)}
      </select></span
    >
  </div>`;
}

export function recordingSection(props: RecordingProps): TemplateResult {
  const { words, clip, result } = props;
  const { t, format } = words;
  const frames = html`${format.integer(result.frames)} · ${lengthText(words, lengthOf(result))}`;
  const facts = html`<dl class="facts">
    ${clip.source.folder ? fact(t('recording.folder'), html`<span title=${clip.source.folder}>${clip.source.folder}</span>`) : nothing}
    ${fact(t('recording.frames'), frames)}
  </dl>`;
  return section(
    t('recording.title'),
    format.bytes(clip.source.blob.size),
    html`${facts}${performers(props)}${overrides(props)}`,
  );
}
