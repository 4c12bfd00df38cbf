/** The picture over the buttons: a real curve of motion speed, and over its valleys the keyposes. */
import { html, nothing, svg, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { drawn } from '../common/directives';
import { drawFlatFigure } from '../figure/draw-flat-figure';
import {
  baseY,
  bodyPx,
  groundY,
  heroHeight,
  heroLayout,
  speedX,
  type HeroLayout,
  type HeroPlace,
} from './hero-layout';
import type { SamplePicture } from './sample-picture';

const dotRadius = 5;

function thread({ x, y, figureX }: HeroPlace): TemplateResult {
  return svg`<path class="hero-thread" d="M${figureX} ${groundY + 9}C${figureX} ${groundY + 30} ${x} ${groundY + 18} ${x} ${y - 6}" />`;
}

function drawFigures(group: Element, { figures }: SamplePicture, { places }: HeroLayout): void {
  for (const { index, figureX } of places) {
    const figure = figures[index];
    if (!figure) continue;
    const x = figureX - (bodyPx * (figure.minX + figure.maxX)) / 2;
    drawFlatFigure(group, figure, { scale: bodyPx, x, groundY });
  }
}

function content(picture: SamplePicture, { t }: Words, width: number): TemplateResult {
  const layout = heroLayout(picture, width);
  const [first] = layout.places;
  return svg`
    <defs>
      <linearGradient id="hero-fade"><stop offset="0" stop-color="#fff" stop-opacity="0" /><stop offset=".07" stop-color="#fff" />
        <stop offset=".93" stop-color="#fff" /><stop offset="1" stop-color="#fff" stop-opacity="0" /></linearGradient>
      <mask id="hero-mask"><rect width=${width} height=${heroHeight} fill="url(#hero-fade)" /></mask>
    </defs>
    <g mask="url(#hero-mask)"><path class="hero-area" d=${layout.area} /><path class="hero-curve" d=${layout.curve} /></g>
    ${layout.places.map(thread)}
    ${layout.places.map(({ x, y }) => svg`<circle class="hero-dot" cx=${x} cy=${y} r=${dotRadius} />`)}
    ${
      first
        ? svg`<text class="hero-label" x=${speedX} y=${layout.speedY}>${t('empty.speed')}</text>
        <text class="hero-keypose" x=${first.x - dotRadius} y=${baseY + 20}>${t('empty.settles')}</text>`
        : nothing
    }
    <g ${drawn(`${picture.frames.join()} ${width}`, (group) => drawFigures(group, picture, layout))}></g>
  `;
}

/** Its room is there from the start, so that nothing moves when the picture comes. */
export function hero(picture: SamplePicture | null, words: Words, width: number): TemplateResult {
  return html`<svg
    class="hero ${picture ? 'shown' : ''}"
    viewBox="0 0 ${width} ${heroHeight}"
    role="img"
    aria-label=${words.t('empty.picture')}
  >
    ${picture ? content(picture, words, width) : nothing}
  </svg>`;
}
