/** Which joint of the file stands for which part of the body, where that came from, and another one instead. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { iconButton } from '../common/buttons';
import { drawn } from '../common/directives';
import { icon } from '../common/icons';
import type { BodyJoint, PerformerResult, Role, Skeleton } from '../engine/types';
import { glyph, sideOf } from './body-figure';
import type { JointRole } from '../app/joint-choices';

export interface JointTable {
  readonly words: Words;
  readonly performer: PerformerResult;
  /** Whatever changes which joints the rows show. */
  readonly basis: string;
  readonly pelvisByHand: boolean;
  readonly pointed: Role | null;
  readonly onPoint: (role: Role | null) => void;
  /** null: as found. */
  readonly onJoint: (role: JointRole, joint: number | null) => void;
}

interface Row {
  readonly role: JointRole;
  readonly joint: number;
  /** null: it follows from the others. */
  readonly source: BodyJoint['source'] | null;
}

export const jointFieldId = (role: JointRole): string => `joint-${role}`;

const jointName = ({ labels, endSites }: Skeleton, joint: number): string =>
  endSites[joint] ? (labels[joint] ?? '').replace(/\/end$/, ' · end') : (labels[joint] ?? '');

function option(value: string, text: string): HTMLOptionElement {
  const element = document.createElement('option');
  element.value = value;
  element.textContent = text;
  return element;
}

/** A list of every joint for each of 19 parts would be thousands of elements: it is filled when it is reached. */
function fill(
  select: HTMLSelectElement,
  { words, performer: { skeleton } }: JointTable,
  row: Row,
): void {
  if (select.options.length > 1) return;
  const all = skeleton.labels.map((_, joint) => option(String(joint), jointName(skeleton, joint)));
  const automatic = row.source === 'user' ? [option('', words.t('recording.automatic'))] : [];
  select.replaceChildren(...automatic, ...all);
  select.value = String(row.joint);
}

function jointSelect(table: JointTable, row: Row): TemplateResult {
  const {
    performer: { skeleton },
    basis,
    onJoint,
    words,
  } = table;
  const reach = (event: Event): void => fill(event.currentTarget as HTMLSelectElement, table, row);
  const onChange = (event: Event): void => {
    const { value } = event.target as HTMLSelectElement;
    onJoint(row.role, value === '' ? null : Number(value));
  };
  const show = (element: Element): void => {
    element.append(option(String(row.joint), jointName(skeleton, row.joint)));
  };
  return html`<span class="joint-select"
    ><select
      id=${jointFieldId(row.role)}
      aria-label=${words.t(`role.${row.role}`)}
      @pointerdown=${reach}
      @focus=${reach}
      @change=${onChange}
      ${drawn(`${basis} ${row.role} ${row.joint} ${row.source} ${words.language}`, show)}
    ></select>
    ${icon('chevron-down', 12)}</span
  >`;
}

function sourceCell({ words: { t }, onJoint }: JointTable, { role, source }: Row): unknown {
  if (source === null) return nothing;
  if (source === 'name')
    return html`${icon('check', 13)}<span class="spoken">${t('source.name')}</span>`;
  if (source !== 'user') return t(`source.${source}`);
  return iconButton({
    name: 'reset',
    label: t('recording.reset', t(`role.${role}`)),
    size: 13,
    small: true,
    onPress() {
      onJoint(role, null);
      document.getElementById(jointFieldId(role))?.focus();
    },
  });
}

function jointRow(table: JointTable, row: Row): TemplateResult {
  const {
    words: { t },
    performer: { skeleton },
    pointed,
    onPoint,
  } = table;
  const { role, joint, source } = row;
  const side = role === 'pelvis' ? 'trunk' : sideOf(role);
  const point = (on: boolean) => () => onPoint(on && role !== 'pelvis' ? role : null);
  return html`<tr
    class="joint-row ${pointed === role ? 'pointed' : ''} ${source === 'user' ? 'changed' : ''}"
    @pointerenter=${point(true)}
    @pointerleave=${point(false)}
    @focusin=${point(true)}
    @focusout=${point(false)}
  >
    <th scope="row">
      <span class="joint-part side-${side} source-${source ?? 'name'}"
        >${source ? glyph(source) : html`<span class="glyph"></span>`}<span
          >${t(`role.${role}`)}</span
        ></span
      >
    </th>
    <td title=${skeleton.labels[joint] ?? ''}>${jointSelect(table, row)}</td>
    <td class="joint-source" title=${source ? t(`source.${source}`) : nothing}>
      ${sourceCell(table, row)}
    </td>
  </tr>`;
}

const isHip = ({ role }: BodyJoint): boolean => role.endsWith('_hip');

export function jointTable(table: JointTable): TemplateResult {
  const {
    words: { t },
    performer: { body },
    pelvisByHand,
  } = table;
  const principal = body.joints.filter((joint) => !isHip(joint));
  const pelvis: Row = { role: 'pelvis', joint: body.pelvis, source: pelvisByHand ? 'user' : null };
  const rows = (all: readonly Row[]): TemplateResult =>
    html`<tbody>
      ${all.map((row) => jointRow(table, row))}
    </tbody>`;
  const plain = body.joints.every(({ source }) => source === 'name') && !pelvisByHand;
  return html`<table class="joints ${plain ? 'all-by-name' : ''}">
    <colgroup>
      <col class="joint-role" />
      <col />
      <col class="joint-found" />
    </colgroup>
    <thead class="spoken">
      <tr>
        <th scope="col">${t('body.role')}</th>
        <th scope="col">${t('body.joint')}</th>
        <th scope="col">${t('body.source')}</th>
      </tr>
    </thead>
    ${rows(principal)} ${rows([pelvis, ...body.joints.filter(isHip)])}
  </table>`;
}
