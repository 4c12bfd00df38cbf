/** The cut and the heights of the tree in; a handle "6 clusters" that is dragged or moved by keys out. */
import { html, nothing, render } from 'lit-html';
import { element } from '../common/element';
import type { Words } from '../app/i18n/catalogue';
import { topPx, type MatrixGeometry } from './matrix-geometry';
import { clustersAt } from './tree-layout';
import type { Scene } from './scene';

export interface CutState {
  readonly scene: Scene;
  readonly geometry: MatrixGeometry;
  readonly words: Words;
  /** What the person set it to, which the scene follows a moment later; null: automatic. */
  readonly wanted: number | null;
}

const pageStep = 5;

export class CutSlider {
  readonly element = element('div', 'tree-cut');
  private readonly line = element('div', 'tree-cut-line');
  private readonly handle = element('div', 'tree-cut-handle');
  private readonly reset = element('div', 'tree-cut-reset');
  private state: CutState | null = null;
  /** Pixels of the pointer's place while it drags. */
  private dragX: number | null = null;
  /** As in the state, but at once: keys come faster than drawings. */
  private wanted: number | null = null;

  constructor(private readonly tellCut: (clusters: number | null) => void) {
    const { handle } = this;
    this.element.setAttribute('role', 'group');
    handle.tabIndex = 0;
    handle.setAttribute('role', 'slider');
    handle.setAttribute('aria-valuemin', '1');
    this.element.append(this.line, handle, this.reset);
    handle.addEventListener('keydown', this.onKey);
    handle.addEventListener('pointerdown', (event) => {
      if (event.button === 0) handle.setPointerCapture(event.pointerId);
    });
    handle.addEventListener('pointermove', this.onDrag);
    handle.addEventListener('lostpointercapture', () => {
      this.dragX = null;
      this.place();
    });
    handle.addEventListener('dblclick', () => this.setCut(null));
  }

  update(state: CutState | null): void {
    this.state = state;
    this.wanted = state?.wanted ?? null;
    const cut = state?.scene.cut ?? null;
    const hidden = !state || !cut || state.geometry.treeWidth === 0;
    this.element.hidden = hidden;
    if (hidden || !state || !cut) return;
    const { words, scene, wanted } = state;
    const byHand = wanted !== null;
    const text = words.t('tree.clusters', cut.clusters);
    this.element.setAttribute('aria-label', words.t('tree.label'));
    this.handle.setAttribute('aria-label', words.t('tree.cut'));
    this.handle.setAttribute('aria-valuemax', String(scene.count));
    this.handle.setAttribute('aria-valuenow', String(cut.clusters));
    this.handle.setAttribute('aria-valuetext', text);
    this.element.classList.toggle('by-hand', byHand);
    render(html`<span class="tree-cut-grip"></span>${text}`, this.handle);
    render(byHand ? this.resetButton(state) : nothing, this.reset);
    this.place();
  }

  private setCut(clusters: number | null): void {
    this.wanted = clusters;
    this.tellCut(clusters);
  }

  /** Where the cut is, or is about to be. */
  private clusters({ cut, count }: Scene): number | undefined {
    return this.wanted === null ? cut?.clusters : Math.min(count, this.wanted);
  }

  private resetButton({ words: { t }, scene }: CutState) {
    const press = (): void => {
      this.setCut(null);
      this.handle.focus();
    };
    return html`<button
      type="button"
      class="tree-cut-auto"
      data-tip=${t('tree.auto.about', scene.comparison.automaticClusters)}
      @click=${press}
    >
      ${t('tree.auto')}
    </button>`;
  }

  private place(): void {
    const { state } = this;
    if (!state?.scene.cut) return;
    const { heights, side } = state.geometry;
    const x = this.dragX ?? heights.x(state.scene.cut.height);
    this.line.style.left = `${x}px`;
    this.line.style.height = `${side + topPx - 20}px`;
    const half = this.handle.offsetWidth / 2;
    this.handle.style.left = `${Math.max(half + 2, x)}px`;
    this.reset.style.left = `${Math.max(half + 2, x) + half + 4}px`;
  }

  private readonly onDrag = (event: PointerEvent): void => {
    const { state, handle } = this;
    if (!state || !handle.hasPointerCapture(event.pointerId)) return;
    const left = this.element.getBoundingClientRect().left;
    const { heights, namesLeft } = state.geometry;
    this.dragX = Math.max(state.geometry.treeLeft, Math.min(namesLeft - 6, event.clientX - left));
    this.place();
    const clusters = clustersAt(state.scene.comparison.tree.heights, heights.height(this.dragX));
    if (clusters !== this.clusters(state.scene)) this.setCut(clusters);
  };

  private readonly onKey = (event: KeyboardEvent): void => {
    const { scene } = this.state ?? {};
    const clusters = scene && this.clusters(scene);
    if (!scene || clusters === undefined) return;
    const goals: Readonly<Record<string, number>> = {
      ArrowRight: clusters + 1,
      ArrowUp: clusters + 1,
      ArrowLeft: clusters - 1,
      ArrowDown: clusters - 1,
      PageUp: clusters + pageStep,
      PageDown: clusters - pageStep,
      Home: 1,
      End: scene.count,
    };
    const automatic = event.key === 'Delete' || event.key === 'Backspace';
    if (automatic) this.setCut(null);
    else if (event.key in goals) this.setCut(Math.max(1, Math.min(scene.count, goals[event.key])));
    else return;
    event.preventDefault();
  };
}
