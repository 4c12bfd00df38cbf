/** The scene and its geometry in; the names beside their rows out, or, where rows are low, in a lens. */
import { html, nothing, render, type TemplateResult } from 'lit-html';
import { repeat } from 'lit-html/directives/repeat.js';
import { styled } from '../common/directives';
import { element } from '../common/element';
import { nameLine } from './clip-words';
import { positionsInSight } from './matrix-canvas';
import { topPx, type MatrixGeometry } from './matrix-geometry';
import type { Scene } from './scene';
import { choose, hover, type ItemPair, type Shared } from './shared';
import { itemMark } from './item-mark';

export interface NamesState {
  readonly scene: Scene;
  readonly geometry: MatrixGeometry;
  readonly selected: ItemPair;
  readonly hovered: ItemPair | null;
}

/** Names on either side of the hovered one that the lens shows. */
const lensReach = 4;
const lensLinePx = 16;
const leastRowPx = 12;

export class NamesView {
  readonly element = element('div', 'matrix-names');
  readonly lens = element('div', 'matrix-lens');
  private state: NamesState | null = null;
  /** The position at which the Tab key stops. */
  private stop = 0;
  private wantsFocus = false;

  constructor(
    private readonly shared: Shared,
    private readonly onReach: (position: number) => void,
  ) {
    this.lens.setAttribute('aria-hidden', 'true');
    this.element.setAttribute('role', 'listbox');
    this.element.setAttribute('aria-multiselectable', 'true');
    this.element.addEventListener('keydown', this.onKey);
    this.element.addEventListener('pointermove', ({ clientY }) => this.hoverAt(clientY));
    this.element.addEventListener('pointerleave', () => hover(this.shared, null));
    this.element.addEventListener('click', (event) => this.onClick(event));
  }

  update(state: NamesState): void {
    this.state = state;
    const { geometry, scene, selected } = state;
    const { style } = this.element;
    style.left = `${geometry.namesLeft}px`;
    style.top = `${topPx}px`;
    style.width = `${geometry.namesWidth}px`;
    style.height = `${geometry.side}px`;
    const { t } = this.shared.context.language.words.value;
    this.element.setAttribute('aria-label', t('names.label'));
    this.element.setAttribute('aria-description', t('names.help'));
    const hasFocus = this.element.contains(document.activeElement);
    if (!hasFocus && selected.a !== null) this.stop = scene.positionOfItem[selected.a];
    this.stop = Math.min(this.stop, scene.count - 1);
    render(this.options(state), this.element);
    this.showLens(state);
    if (this.wantsFocus) this.focusStop();
  }

  private focusStop(): void {
    this.wantsFocus = false;
    this.element.querySelector<HTMLElement>('[tabindex="0"]')?.focus({ preventScroll: true });
  }

  /** Of low rows only the one at which the Tab key stops exists. */
  private options({ geometry, scene, selected }: NamesState): TemplateResult {
    const { first, end } = positionsInSight(geometry, geometry.zoom.y);
    const all = Array.from({ length: end - first }, (_, k) => first + k);
    const positions = geometry.named ? all : [this.stop];
    if (!positions.includes(this.stop) && positions.length > 0) positions.push(this.stop);
    return html`${repeat(
      positions,
      (position) => scene.order[position],
      (position) => this.option(scene, geometry, selected, position),
    )}`;
  }

  private option(
    scene: Scene,
    { axis, zoom, named }: MatrixGeometry,
    { a, b }: ItemPair,
    position: number,
  ): TemplateResult {
    const item = scene.order[position];
    const { t } = this.shared.context.language.words.value;
    const label = scene.labels[scene.labelOfItem[item]] ?? t('names.no-label');
    const top = axis.start(position) - zoom.y;
    const height = named ? axis.cell : Math.max(axis.cell, leastRowPx);
    return html`<div
      role="option"
      class="matrix-name ${named ? '' : 'low'}"
      aria-selected=${item === a || item === b ? 'true' : 'false'}
      aria-label="${scene.names[item]}, ${label}"
      aria-setsize=${scene.count}
      aria-posinset=${position + 1}
      title=${scene.names[item]}
      tabindex=${position === this.stop ? 0 : -1}
      ${styled({ top: `${top}px`, height: `${height}px`, 'line-height': `${height}px` })}
    >
      ${named ? html`${itemMark(scene.labelOfItem[item])}${nameLine(scene.names[item])}` : nothing}
    </div>`;
  }

  private showLens({ geometry, scene, hovered }: NamesState): void {
    const item = hovered?.a ?? null;
    this.lens.hidden = geometry.named || item === null;
    if (this.lens.hidden || item === null) return;
    const at = scene.positionOfItem[item];
    const [first, end] = [Math.max(0, at - lensReach), Math.min(scene.count, at + lensReach + 1)];
    const positions = Array.from({ length: end - first }, (_, k) => first + k);
    const line = (position: number): TemplateResult => {
      const shown = scene.order[position];
      return html`<div class=${shown === item ? 'here' : ''}>
        ${itemMark(scene.labelOfItem[shown])}<span>${scene.names[shown]}</span>
      </div>`;
    };
    render(html`${positions.map(line)}`, this.lens);
    const middle = topPx + geometry.axis.middle(at) - geometry.zoom.y;
    const top = middle - (at - first + 0.5) * lensLinePx - 5;
    const most = geometry.height - positions.length * lensLinePx - 12;
    this.lens.style.top = `${Math.max(0, Math.min(top, most))}px`;
    this.lens.style.left = `${Math.max(4, geometry.left - this.lens.offsetWidth - 4)}px`;
  }

  private positionAt(clientY: number): number | null {
    if (!this.state || this.state.scene.count === 0) return null;
    const { axis, zoom } = this.state.geometry;
    const y = clientY - this.element.getBoundingClientRect().top;
    return axis.nearest(y + zoom.y);
  }

  private hoverAt(clientY: number): void {
    const position = this.positionAt(clientY);
    const item = position === null ? undefined : this.state?.scene.order[position];
    hover(this.shared, item === undefined ? null : { a: item, b: item });
  }

  private onClick(event: MouseEvent): void {
    const position = this.positionAt(event.clientY);
    if (position !== null) this.take(position, event.shiftKey || event.ctrlKey || event.metaKey);
  }

  private take(position: number, second: boolean): void {
    const item = this.state?.scene.order[position];
    if (item === undefined) return;
    this.stop = position;
    choose(this.shared, item, second ? 'b' : 'a');
  }

  private readonly onKey = (event: KeyboardEvent): void => {
    const last = (this.state?.scene.count ?? 1) - 1;
    const goals: Readonly<Record<string, number>> = {
      ArrowUp: this.stop - 1,
      ArrowDown: this.stop + 1,
      PageUp: this.stop - 10,
      PageDown: this.stop + 10,
      Home: 0,
      End: last,
    };
    if (event.key === 'Enter' || event.key === ' ') this.take(this.stop, event.shiftKey);
    else if (event.key in goals && this.state) {
      this.stop = Math.max(0, Math.min(last, goals[event.key]));
      const item = this.state.scene.order[this.stop];
      hover(this.shared, { a: item, b: item });
      this.wantsFocus = true;
      this.update(this.state);
      this.onReach(this.stop);
    } else return;
    event.preventDefault();
  };
}
