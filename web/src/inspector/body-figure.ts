/** A small figure with the joints on it: the one that is pointed at in, another one out. */
import { html, nothing, svg, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { drawn } from '../common/directives';
import type { BodyJoint, Role } from '../engine/types';
import { drawFlatFigure, fitFigure } from '../figure/draw-flat-figure';
import type { FlatFigure } from '../figure/flat-figure';
import { glyphPath, jointSources } from './source-glyph';
import { standardFigure, standardPlace } from '../figure/standard-body';

export const figureWidth = 272;
export const figureHeight = 206;
const padding = 10;
const dotRadius = 4.2;
const pointedRadius = 6;
const ringRadius = 9.5;

export interface BodyFigure {
  readonly words: Words;
  readonly joints: readonly BodyJoint[];
  readonly pointed: Role | null;
  readonly onPoint: (role: Role | null) => void;
  readonly onChoose: (role: Role) => void;
}

export const sideOf = (role: Role): 'left' | 'right' | 'trunk' =>
  role.startsWith('left') ? 'left' : role.startsWith('right') ? 'right' : 'trunk';

const standard = standardFigure();
const place = fitFigure(standard, figureWidth, figureHeight, padding);

const draw =
  (figure: FlatFigure, at = fitFigure(figure, figureWidth, figureHeight, padding)) =>
  (parent: Element): void => {
    drawFlatFigure(parent, figure, at);
  };

function dot(
  { pointed, onPoint, onChoose }: BodyFigure,
  { role, source }: BodyJoint,
): TemplateResult {
  const [bodyX, bodyY] = standardPlace(role);
  const x = place.x + bodyX * place.scale;
  const y = place.groundY - bodyY * place.scale;
  const isPointed = role === pointed;
  const ring = svg`<circle class="joint-ring" cx=${x} cy=${y} r=${ringRadius} />`;
  return svg`<g class="joint-dot side-${sideOf(role)} source-${source}"
    @pointerenter=${() => onPoint(role)} @pointerleave=${() => onPoint(null)} @click=${() => onChoose(role)}>
    <circle class="joint-hit" cx=${x} cy=${y} r=${ringRadius} />
    <path d=${glyphPath(source, x, y, isPointed ? pointedRadius : dotRadius)} />
    ${isPointed ? ring : nothing}
  </g>`;
}

function legend({ words: { t }, joints }: BodyFigure): TemplateResult | typeof nothing {
  const used = jointSources.filter((source) => joints.some((joint) => joint.source === source));
  if (used.length < 2) return nothing;
  const key = (source: BodyJoint['source']): TemplateResult =>
    html`<li class="side-trunk source-${source}">${glyph(source)}${t(`source.${source}`)}</li>`;
  return html`<ul class="joint-legend">
    ${used.map(key)}
  </ul>`;
}

/** The shape of a source beside a text. */
export function glyph(source: BodyJoint['source']): TemplateResult {
  return html`<svg class="glyph" width="12" height="12" viewBox="0 0 12 12" aria-hidden="true">
    <path d=${glyphPath(source, 6, 6.2, 3.7)} />
  </svg>`;
}

/** The joints of the table below, so that nothing of it is for eyes only. */
export function bodyFigure(figure: BodyFigure): TemplateResult {
  const {
    words: { t },
    joints,
  } = figure;
  return html`<svg
      class="body-figure"
      viewBox="0 0 ${figureWidth} ${figureHeight}"
      role="img"
      aria-label=${t('body.figure')}
    >
      <g class="faint" ${drawn(standard, draw(standard, place))}></g>
      <text class="side-right" x="0" y="12">${t('body.right')}</text>
      <text class="side-left" x=${figureWidth} y="12" text-anchor="end">${t('body.left')}</text>
      ${joints.map((joint) => dot(figure, joint))}
    </svg>
    ${legend(figure)}`;
}

/** Any other body, as it stands in its thumbnail. */
export function plainFigure({ t }: Words, figure: FlatFigure): TemplateResult {
  return html`<svg
    class="body-figure"
    viewBox="0 0 ${figureWidth} ${figureHeight}"
    role="img"
    aria-label=${t('body.figure.other')}
    ${drawn(figure, draw(figure))}
  ></svg>`;
}
