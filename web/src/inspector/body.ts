/** Whose body it is, how large, and which joint of the file stands for which part of it. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { splitName } from '../app/names';
import { icon } from '../common/icons';
import type { BodyJoint, PerformerResult } from '../engine/types';
import { fact, section } from './section';

const sideOf = ({ role }: BodyJoint): string =>
  role.startsWith('left') ? 'left' : role.startsWith('right') ? 'right' : 'trunk';

function jointRow({ t }: Words, joint: BodyJoint, label: string): TemplateResult {
  const [head, tail] = splitName(label);
  const source = t(`source.${joint.source}`);
  return html`<tr>
    <th scope="row"><i class="side-dot side-${sideOf(joint)}"></i>${t(`role.${joint.role}`)}</th>
    <td title=${label}>
      <span class="joint-name"
        ><span class="name-head">${head}</span><span class="name-tail">${tail}</span></span
      >
    </td>
    <td class="joint-source" title=${source}>
      ${joint.source === 'name' ? html`${icon('check', 13)}<span class="spoken">${source}</span>` : source}
    </td>
  </tr>`;
}

function jointTable(words: Words, { body, skeleton }: PerformerResult): TemplateResult {
  const { t } = words;
  return html`<table class="joints">
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
    <tbody>
      ${body.joints.map((joint) => jointRow(words, joint, skeleton.labels[joint.joint] ?? ''))}
    </tbody>
  </table>`;
}

function sources({ t, format }: Words, joints: readonly BodyJoint[]): string {
  const count = (...wanted: readonly BodyJoint['source'][]): number =>
    joints.filter(({ source }) => wanted.includes(source)).length;
  if (joints.length === 0) return '';
  if (count('name') === joints.length) return t('body.sources.name');
  return t(
    'body.sources.mixed',
    ...[count('name'), count('shape'), count('fallback', 'user')].map(format.integer),
  );
}

/** Digits enough to tell bodies apart in any unit. */
const digitsFor = (value: number): number =>
  Math.abs(value) >= 100 ? 1 : Math.abs(value) >= 10 ? 2 : 3;

function heightText({ t, format }: Words, { body, unit }: PerformerResult): string {
  const height = format.decimal(body.height, digitsFor(body.height));
  return unit
    ? t('body.height.metric', height, format.decimal(body.height * unit.metres, 2))
    : t('recording.in-file', height);
}

export function bodySection(words: Words, performer: PerformerResult): TemplateResult {
  const { t, format } = words;
  const { body, skeleton, groundHeight } = performer;
  const ground = t('recording.in-file', format.decimal(groundHeight, digitsFor(groundHeight)));
  const facts = html`<dl class="facts">
    ${fact(t('body.kind'), t(body.kind === 'human' ? 'body.human' : 'body.other'))}
    ${fact(t('body.height'), heightText(words, performer))} ${fact(t('recording.ground'), ground)}
    ${body.kind === 'human' ? fact(t('body.pelvis'), skeleton.labels[body.pelvis] ?? '') : nothing}
  </dl>`;
  const table = body.joints.length > 0 ? jointTable(words, performer) : nothing;
  const beside =
    body.joints.length > 0 ? sources(words, body.joints) : t('body.joints', skeleton.labels.length);
  return section(t('body.title'), beside, html`${facts}${table}`);
}
