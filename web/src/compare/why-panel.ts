/** The tab "Why": both clips in figures, why they differ in one sentence, in bars and on a body, and what is nearest. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Clip } from '../app/clips';
import type { Words } from '../app/i18n/catalogue';
import { drawn } from '../common/directives';
import { labelMark } from '../common/label-mark';
import type { Explanation, Neighbour } from '../engine/comparison-types';
import type { ClipId } from '../engine/types';
import { drawFlatFigure, fitFigure } from '../figure/draw-flat-figure';
import type { FlatFigure } from '../figure/flat-figure';
import { mirrorSign, namedMark, nameLine, type LabelOf, type NameOf } from './clip-words';
import { componentBars } from './component-bars';
import { distanceNumber } from './distance-number';
import { paintedBody } from './painted-body';
import { figureBoxHeight, figureBoxWidth, stripGround, stripScale } from './strip-figures';
import { whySentence } from './why-sentence';

export interface WhyPanelProps {
  readonly words: Words;
  readonly a: Clip | null;
  readonly b: Clip | null;
  readonly figuresA: readonly FlatFigure[];
  readonly figuresB: readonly FlatFigure[];
  /** Of another pair or distance: dimmed. */
  readonly outdated: boolean;
  readonly explanation: Explanation | null;
  readonly neighbours: readonly Neighbour[];
  readonly clips: readonly Clip[];
  readonly nameOf: NameOf;
  readonly labelOf: (id: ClipId) => LabelOf | null;
  readonly onNeighbour: (id: ClipId) => void;
}

/** Letters that a card has room for: of a name, and of the end of a longer one. */
const cardName = 6;
const cardTail = 4;
const cards = 6;
const cardWidth = 58;
const cardHeight = 44;
const cardPadding = 2;

function strip(figures: readonly FlatFigure[], scale: number, groundY: number): TemplateResult {
  const draw = (parent: Element): void =>
    figures.forEach((figure, index) => {
      const middle = (index + 0.5) * figureBoxWidth;
      const x = middle - (scale * (figure.minX + figure.maxX)) / 2;
      drawFlatFigure(parent, figure, { scale, x, groundY });
    });
  return html`<svg
    class="pair-strip"
    viewBox="0 0 ${4 * figureBoxWidth} ${figureBoxHeight}"
    aria-hidden="true"
    ${drawn(`${scale} ${groundY} ${figures.length} ${figures[0]?.maxX}`, draw)}
  ></svg>`;
}

function pairStrips(props: WhyPanelProps): TemplateResult {
  const { a, b, figuresA, figuresB, nameOf, labelOf } = props;
  const all = [...figuresA, ...figuresB];
  const scale = stripScale(all);
  const groundY = stripGround(all, scale);
  const half = (clip: Clip | null, figures: readonly FlatFigure[]): TemplateResult => {
    const label = clip && labelOf(clip.id);
    return html`<div>
      <p class="pair-name" title=${nameOf(clip)}>
        ${label ? labelMark(label.index) : nothing}<b>${nameLine(nameOf(clip))}</b
        ><span class="quiet">${label?.name}</span>
      </p>
      ${strip(figures, scale, groundY)}
    </div>`;
  };
  return html`<div class="pair-strips">${half(a, figuresA)}${half(b, figuresB)}</div>`;
}

function explained(props: WhyPanelProps, explanation: Explanation): TemplateResult {
  const { words, a, b, outdated, nameOf } = props;
  const name = (clip: Clip | null): TemplateResult => html`<b>${nameOf(clip)}</b>`;
  const bars =
    explanation.sentence.kind === 'same'
      ? nothing
      : html`<div class="why-shares">
          ${componentBars(words, explanation.shares)}
          <div class="why-body">
            <h4>${words.t('distance.parts')}</h4>
            ${paintedBody(words, explanation.partShares)}
          </div>
        </div>`;
  return html`<div class=${outdated ? 'dimmed' : ''}>
    ${whySentence(words, explanation, { a: name(a), b: name(b) })}${bars}
  </div>`;
}

function card(props: WhyPanelProps, { clip: id, distance, mirrored }: Neighbour): TemplateResult {
  const { words, clips, b, nameOf, labelOf, onNeighbour } = props;
  const clip = clips[id];
  const figure = clip?.thumbnail ?? null;
  const draw = (parent: Element): void => {
    if (figure)
      drawFlatFigure(parent, figure, fitFigure(figure, cardWidth, cardHeight, cardPadding));
  };
  const name = nameOf(clip);
  return html`<li>
    <button
      type="button"
      class="near-card"
      title=${name}
      aria-pressed=${String(b?.id === id)}
      @click=${() => onNeighbour(id)}
    >
      <svg viewBox="0 0 ${cardWidth} ${cardHeight}" aria-hidden="true" ${drawn(figure, draw)}></svg>
      <span class="near-name ${name.length > cardName ? 'cut' : ''}"
        >${namedMark(labelOf(id))}${nameLine(name, cardTail)}</span
      >
      <span class="near-distance"
        >${distanceNumber(words.format, distance)}${mirrored ? mirrorSign(words) : nothing}</span
      >
    </button>
  </li>`;
}

function nearest(props: WhyPanelProps): TemplateResult | typeof nothing {
  const { words, a, neighbours, nameOf } = props;
  if (!a || neighbours.length === 0) return nothing;
  return html`<section class="nearest">
    <h3>${words.t('neighbours.nearest-to', nameOf(a))}</h3>
    <ul>
      ${neighbours.slice(0, cards).map((one) => card(props, one))}
    </ul>
  </section>`;
}

function hint({ t }: Words, a: Clip | null): TemplateResult {
  return html`<p class="side-hint">${t(a ? 'why-pair.other' : 'why-pair.none')}</p>`;
}

export function whyPanel(props: WhyPanelProps): TemplateResult {
  const { words, a, b, explanation } = props;
  const pair =
    a && b
      ? html`${pairStrips(props)}${
          explanation
            ? explained(props, explanation)
            : html`<p class="side-hint">${words.t('why-pair.apart')}</p>`
        }`
      : hint(words, a);
  return html`<div class="why-pair">${pair}</div>
    ${nearest(props)}`;
}
