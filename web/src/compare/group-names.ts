/** The scene and its geometry in; of rows too low for names, in the order of labels, each label beside its rows, out. */
import { html, render, type TemplateResult } from 'lit-html';
import { styled } from '../common/directives';
import { element } from '../common/element';
import { nameLine } from './clip-words';
import { itemMark } from './item-mark';
import { groupRuns } from './matrix-canvas';
import { topPx, type MatrixGeometry } from './matrix-geometry';
import type { Scene } from './scene';

const linePx = 16;
/** Between the names and the matrix, and between the names and the edge of the pane. */
const besidePx = 10;
const edgePx = 16;

export interface GroupName {
  /** Its place among all; −1: none. */
  readonly label: number;
  /** From the top edge of the matrix. */
  readonly middlePx: number;
}

/** In the middle of those of its rows that are in sight; of names that would touch each other the first stands. */
export function groupNames(scene: Scene, geometry: MatrixGeometry): readonly GroupName[] {
  const { axis, zoom, side, named } = geometry;
  if (scene.kind !== 'label' || named) return [];
  let bottom = -Infinity;
  return groupRuns(scene.groups).flatMap(({ group, first, end }) => {
    const from = Math.max(0, axis.start(first) - zoom.y);
    const to = Math.min(side, axis.start(end - 1) + axis.cell - zoom.y);
    const middlePx = (from + to) / 2;
    if (to <= from || middlePx - linePx / 2 < bottom) return [];
    bottom = middlePx + linePx / 2;
    return [{ label: group, middlePx }];
  });
}

/** Seen only: for ears every row says its label. */
export class GroupNames {
  readonly element = element('div', 'matrix-groups');

  constructor() {
    this.element.setAttribute('aria-hidden', 'true');
  }

  /** `none` is what stands for no label. */
  show(scene: Scene, geometry: MatrixGeometry, none: string): void {
    const { style } = this.element;
    style.left = `${edgePx}px`;
    style.top = `${topPx}px`;
    style.width = `${Math.max(0, geometry.left - besidePx - edgePx)}px`;
    const line = ({ label, middlePx }: GroupName): TemplateResult =>
      html`<div ${styled({ top: `${middlePx - linePx / 2}px` })}>
        ${itemMark(label)}${nameLine(scene.labels[label] ?? none)}
      </div>`;
    render(html`${groupNames(scene, geometry).map(line)}`, this.element);
  }
}
