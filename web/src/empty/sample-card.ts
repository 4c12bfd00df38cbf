/** One sample motion: some of its keyposes as figures, its name and a line about it; one button. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { MessageKey, Words } from '../app/i18n/catalogue';
import { drawn } from '../common/directives';
import type { SampleInfo } from '../engine/types';
import { drawFlatFigure } from '../figure/draw-flat-figure';
import type { SamplePicture } from './sample-picture';

const names: Readonly<Record<SampleInfo['motion'], MessageKey>> = {
  'slow-dance': 'sample.slow-dance',
  'tired-dance': 'sample.tired-dance',
  walk: 'sample.walk',
  run: 'sample.run',
};

const width = 236;
const height = 62;
const mostBodyPx = 46;
const mostFigures = 5;
const gap = 3;

function drawFigures(svg: Element, { figures }: SamplePicture): void {
  const count = Math.min(mostFigures, figures.length);
  const last = Math.max(1, count - 1);
  const shown = Array.from(
    { length: count },
    (_, index) => figures[Math.round((index * (figures.length - 1)) / last)],
  );
  const step = width / count;
  const widest = Math.max(...shown.map((figure) => figure.maxX - figure.minX));
  const scale = Math.min(mostBodyPx, (step - gap) / widest);
  shown.forEach((figure, index) => {
    const x = (index + 0.5) * step - (scale * (figure.minX + figure.maxX)) / 2;
    drawFlatFigure(svg, figure, { scale, x, groundY: height - 4 });
  });
}

export function sampleCard(
  motion: SampleInfo['motion'],
  picture: SamplePicture | null,
  { t }: Words,
  onOpen: () => void,
): TemplateResult {
  const about = picture ? t(`sample.${motion}.about`, picture.frames.length) : nothing;
  return html`<button type="button" class="sample-open" @click=${onOpen}>
    <svg
      class="sample-figures"
      viewBox="0 0 ${width} ${height}"
      aria-hidden="true"
      ${drawn(picture, (svg) => picture && drawFigures(svg, picture))}
    ></svg>
    <strong>${t(names[motion])}</strong>
    <span class="sample-about">${about}&nbsp;</span>
  </button>`;
}
