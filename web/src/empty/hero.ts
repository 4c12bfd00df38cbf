/** The picture over the buttons: a real curve of motion speed, and over its valleys the keyposes. */
import { html, nothing, svg, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { drawn } from '../common/directives';
import { drawFlatFigure } from '../figure/draw-flat-figure';
import type { SamplePicture } from './sample-picture';
import { spread } from './spread';

const width = 1080;
const height = 300;
const sidePadding = 90;
const baseY = height - 26;
const curveHeight = 72;
const groundY = 176;
const bodyPx = 108;
const figureDistance = 92;
/** More would stand in each other's way. */
const mostFigures = 10;
const dotRadius = 5;
/** Where the curve's name stands. */
const speedX = 40;
const speedWidth = 40;

interface Place {
  readonly index: number;
  /** The pin on the curve. */
  readonly x: number;
  readonly y: number;
  /** The figure above it. */
  readonly figureX: number;
}

interface Layout {
  readonly curve: string;
  readonly area: string;
  readonly places: readonly Place[];
  /** Just above the curve where its name stands. */
  readonly speedY: number;
}

function layout({ keyposes, frames }: SamplePicture): Layout {
  const shown = Array.from(frames).slice(0, mostFigures);
  const first = shown[0] ?? 0;
  const last = shown.at(-1) ?? 1;
  const scale = (width - 2 * sidePadding) / Math.max(1, last - first);
  const x = (frame: number): number => sidePadding + (frame - first) * scale;
  const y = (frame: number): number =>
    baseY -
    ((keyposes.speed[frame - keyposes.firstFrame] ?? 0) / keyposes.maximumSpeed) * curveHeight;
  const points = Array.from(keyposes.speed.keys(), (index) => index + keyposes.firstFrame)
    .map((frame) => ({ x: x(frame), y: y(frame) }))
    .filter((point) => point.x > -4 && point.x < width + 4);
  const named = points.filter((point) => point.x > speedX && point.x < speedX + speedWidth);
  const figureX = spread(shown.map(x), figureDistance, sidePadding - 10, width - sidePadding + 10);
  const curve = `M${points.map((point) => `${point.x.toFixed(1)} ${point.y.toFixed(1)}`).join('L')}`;
  return {
    curve,
    area: `${curve}V${baseY}H${points[0]?.x ?? 0}Z`,
    speedY: Math.min(baseY, ...named.map((point) => point.y)) - 8,
    places: shown.map((frame, index) => ({
      index,
      x: x(frame),
      y: y(frame),
      figureX: figureX[index] ?? 0,
    })),
  };
}

function thread({ x, y, figureX }: Place): TemplateResult {
  return svg`<path class="hero-thread" d="M${figureX} ${groundY + 9}C${figureX} ${groundY + 30} ${x} ${groundY + 18} ${x} ${y - 6}" />`;
}

function drawFigures(group: Element, picture: SamplePicture, places: readonly Place[]): void {
  for (const { index, figureX } of places) {
    const figure = picture.figures[index];
    if (!figure) continue;
    const x = figureX - (bodyPx * (figure.minX + figure.maxX)) / 2;
    drawFlatFigure(group, figure, { scale: bodyPx, x, groundY });
  }
}

function content(picture: SamplePicture, { t }: Words): TemplateResult {
  const { curve, area, places, speedY } = layout(picture);
  const [first] = places;
  return svg`
    <defs>
      <linearGradient id="hero-fade"><stop offset="0" stop-color="#fff" stop-opacity="0" /><stop offset=".07" stop-color="#fff" />
        <stop offset=".93" stop-color="#fff" /><stop offset="1" stop-color="#fff" stop-opacity="0" /></linearGradient>
      <mask id="hero-mask"><rect width=${width} height=${height} fill="url(#hero-fade)" /></mask>
    </defs>
    <g mask="url(#hero-mask)"><path class="hero-area" d=${area} /><path class="hero-curve" d=${curve} /></g>
    ${places.map(thread)}
    ${places.map(({ x, y }) => svg`<circle class="hero-dot" cx=${x} cy=${y} r=${dotRadius} />`)}
    ${
      first
        ? svg`<text class="hero-label" x=${speedX} y=${speedY}>${t('empty.speed')}</text>
        <text class="hero-keypose" x=${first.x - dotRadius} y=${baseY + 20}>${t('empty.settles')}</text>`
        : nothing
    }
    <g ${drawn(picture, (group) => drawFigures(group, picture, places))}></g>
  `;
}

/** Its room is there from the start, so that nothing moves when the picture comes. */
export function hero(picture: SamplePicture | null, words: Words): TemplateResult {
  return html`<svg
    class="hero ${picture ? 'shown' : ''}"
    viewBox="0 0 ${width} ${height}"
    preserveAspectRatio="xMidYMax slice"
    role="img"
    aria-label=${words.t('empty.picture')}
  >
    ${picture ? content(picture, words) : nothing}
  </svg>`;
}
