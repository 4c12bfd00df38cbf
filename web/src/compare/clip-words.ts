/** How the page Compare names a clip and marks it: short name, shape of its label, mirror sign. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Clip } from '../app/clips';
import type { Words } from '../app/i18n/catalogue';
import { qualifiedName } from '../app/names';
import { clipName } from '../common/clip-name';
import { labelMark } from '../common/label-mark';
import type { ClipId } from '../engine/types';

/** A file name without its ending. */
export const plainName = (name: string): string => name.replace(/\.bvh$/i, '');

/** Letters that always show of a name without its ending. */
const plainTail = 5;

/** Such a name in one line; where room is short it loses its middle. */
export const nameLine = (name: string, tail = plainTail): TemplateResult =>
  clipName(name, '', tail);

export type NameOf = (clip: Clip | null | undefined) => string;

/** File names without their ending, told apart; the same everywhere on the page. */
export const clipNames =
  (qualifiers: ReadonlyMap<ClipId, string>): NameOf =>
  (clip) =>
    clip ? qualifiedName(plainName(clip.source.name), qualifiers.get(clip.id)) : '';

/** A label and its place among all. */
export interface LabelOf {
  readonly name: string;
  readonly index: number;
}

export function namedMark(label: LabelOf | null): TemplateResult | typeof nothing {
  return label
    ? html`${labelMark(label.index)}<span class="spoken">${label.name} </span>`
    : nothing;
}

export function mirrorSign({ t }: Words): TemplateResult {
  const about = t('neighbours.mirrored');
  return html`<span class="mirror-sign" title=${about}
    ><span aria-hidden="true">⇋</span><span class="spoken"> ${about}</span></span
  >`;
}
