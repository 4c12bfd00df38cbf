/** Whose body it is, how large, how it stands, and which joint of the file stands for which part of it. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { icon } from '../common/icons';
import type { BodyJoint, PerformerResult, Role } from '../engine/types';
import { bodyFigure, plainFigure } from './body-figure';
import { digitsFor, groundRow, unitRow, upAxisRow, type ClipSettingsProps } from './clip-settings';
import type { JointCopies, JointRole } from '../app/joint-choices';
import { jointFieldId, jointTable } from './joint-table';
import { fact, section } from './section';

export interface BodyProps extends ClipSettingsProps {
  readonly performerIndex: number;
  readonly pointed: Role | null;
  readonly copies: JointCopies;
  readonly onPoint: (role: Role | null) => void;
  readonly onJoint: (role: JointRole, joint: number | null) => void;
  readonly onCopy: () => void;
}

function sources({ t, format }: Words, joints: readonly BodyJoint[]): string {
  const count = (wanted: BodyJoint['source']): number =>
    joints.filter(({ source }) => source === wanted).length;
  if (count('name') === joints.length) return t('body.sources.name');
  const counts = (['name', 'shape', 'fallback', 'user'] as const)
    .filter((source) => count(source) > 0)
    .map((source) => t('body.sources.one', format.integer(count(source)), t(`source.${source}`)));
  return counts.join(t('join.list'));
}

function heightText({ t, format }: Words, { body, unit }: PerformerResult): string {
  const height = format.decimal(body.height, digitsFor(body.height));
  return unit
    ? t('body.height.metric', height, format.decimal(body.height * unit.metres, 2))
    : t('recording.in-file', height);
}

function figureSection(props: BodyProps): TemplateResult {
  const { words, performer, clip, performerIndex, pointed, onPoint } = props;
  const { t } = words;
  const { kind, joints } = performer.body;
  const { thumbnail } = clip;
  const isPrincipal = ({ role }: BodyJoint): boolean => !role.endsWith('_hip');
  const human = (): TemplateResult =>
    bodyFigure({
      words,
      joints: joints.filter((joint) => isPrincipal(joint) || joint.role === pointed),
      pointed,
      onPoint,
      onChoose: (role) => document.getElementById(jointFieldId(role))?.focus(),
    });
  const other = (): TemplateResult =>
    html`${thumbnail && performerIndex === 0 ? plainFigure(words, thumbnail) : nothing}
      <p class="quiet">${t('body.other.about')}</p>`;
  return section({
    label: t('body.title'),
    beside: t(kind === 'human' ? 'body.human' : 'body.other'),
    body: joints.length > 0 ? human() : other(),
  });
}

function copyButton({ words: { t }, clip, performerIndex, copies, onCopy }: BodyProps): unknown {
  const decided = clip.decisions.joints?.some(({ performer }) => performer === performerIndex);
  if (copies.clips === 0 || (!decided && copies.changes.length === 0)) return nothing;
  return html`<button
    type="button"
    class="button line wide"
    ?disabled=${copies.changes.length === 0}
    @click=${onCopy}
  >
    ${icon('copy', 14)}${t('body.copy', copies.clips)}
  </button>`;
}

function jointsSection(props: BodyProps): TemplateResult {
  const { words, performer, clip, performerIndex, pointed, onPoint, onJoint } = props;
  const pelvisByHand = (clip.decisions.joints ?? []).some(
    (one) => one.performer === performerIndex && one.role === 'pelvis',
  );
  const basis = `${clip.id} ${performerIndex}`;
  const table = { words, performer, basis, pelvisByHand, pointed, onPoint, onJoint };
  const principal = performer.body.joints.filter(({ role }) => !role.endsWith('_hip'));
  return section({
    label: words.t('body.joints.title'),
    beside: clip.outdated ? words.t('result.updating') : sources(words, principal),
    body: html`${jointTable(table)}${copyButton(props)}`,
    outdated: clip.outdated,
  });
}

function measuresSection(props: BodyProps): TemplateResult {
  const { words, performer } = props;
  const { t, format } = words;
  const { body, skeleton } = performer;
  const facts = html`<dl class="facts">
    ${fact(t('body.height'), heightText(words, performer))}
    ${body.kind === 'human' ? nothing : fact(t('body.all-joints'), format.integer(skeleton.labels.length))}
  </dl>`;
  return section({
    label: t('body.measures'),
    title: false,
    body: html`${upAxisRow(props)}${unitRow(props)}${groundRow(props)}${facts}`,
  });
}

export function body(props: BodyProps): TemplateResult {
  const human = props.performer.body.joints.length > 0;
  return html`${figureSection(props)} ${human ? jointsSection(props) : nothing}
  ${measuresSection(props)}`;
}
