/** The page before there is anything: what it does, where to drop files, samples to try. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { MessageKey, Words } from '../app/i18n/catalogue';
import { drawn } from '../common/directives';
import { icon } from '../common/icons';
import type { SampleInfo } from '../engine/types';
import { drawFlatFigure } from '../figure/draw-flat-figure';
import { hero } from './hero';
import type { SamplePicture } from './sample-picture';

export interface EmptyProps {
  readonly words: Words;
  readonly samples: readonly SampleInfo[];
  readonly pictures: readonly SamplePicture[];
  readonly onFiles: () => void;
  readonly onFolder: () => void;
  readonly onSample: (id: string) => void;
}

const sampleNames: Readonly<Record<SampleInfo['motion'], MessageKey>> = {
  'slow-dance': 'sample.slow-dance',
  walk: 'sample.walk',
};

const cardWidth = 500;
const cardHeight = 66;
const cardBodyPx = 47;
const mostCardFigures = 8;

function drawCard(svg: Element, { figures }: SamplePicture): void {
  const shown = figures.slice(0, mostCardFigures);
  const step = cardWidth / shown.length;
  shown.forEach((figure, index) => {
    const x = (index + 0.5) * step - (cardBodyPx * (figure.minX + figure.maxX)) / 2;
    drawFlatFigure(svg, figure, { scale: cardBodyPx, x, groundY: cardHeight - 4 });
  });
}

function sampleCard(
  { words: { t }, pictures, samples, onSample }: EmptyProps,
  motion: SampleInfo['motion'],
): TemplateResult | typeof nothing {
  const kinds = samples.filter((sample) => sample.motion === motion);
  const [first, ...others] = kinds;
  if (!first) return nothing;
  const picture = pictures.find((known) => known.motion === motion);
  const about = picture ? t(`sample.${motion}.about`, picture.frames.length) : nothing;
  return html`<div class="sample-card">
    <button type="button" class="sample-open" @click=${() => onSample(first.id)}>
      <svg
        class="sample-figures"
        viewBox="0 0 ${cardWidth} ${cardHeight}"
        aria-hidden="true"
        ${drawn(picture, (svg) => picture && drawCard(svg, picture))}
      ></svg>
      <strong>${t(sampleNames[motion])}</strong>
      <span class="sample-about">${about}&nbsp;</span>
    </button>
    ${
      others.length > 0
        ? html`<p class="sample-others">
            <span>${t('sample.rigs')}</span>${others.map(
              ({ id, fileName }) =>
                html`<button type="button" class="sample-other" @click=${() => onSample(id)}>
                  ${fileName}
                </button>`,
            )}
          </p>`
        : nothing
    }
  </div>`;
}

export function emptyPage(props: EmptyProps): TemplateResult {
  const { words } = props;
  const { t } = words;
  const picture = props.pictures.find(({ motion }) => motion === 'slow-dance') ?? null;
  return html`
    <div class="empty-column">
      <h1>${t('empty.title')}</h1>
      <div class="drop-zone">
        <svg class="drop-edge" aria-hidden="true"><rect x="1" y="1" rx="15" /></svg>
        ${hero(picture, words)}
        <p class="drop-sentence">${t('empty.drop')}</p>
        <div class="drop-buttons">
          <button type="button" class="button primary big" @click=${props.onFiles}>
            ${icon('file-up', 17)}${t('empty.files')}
          </button>
          <button type="button" class="button line big" @click=${props.onFolder}>
            ${icon('folder-open', 17)}${t('empty.folder')}
          </button>
        </div>
        <p class="drop-private">${icon('lock', 15)}${t('empty.private')}</p>
      </div>
      <section class="samples" aria-label=${t('sample.title')}>
        <div class="samples-head">
          <h2>${t('sample.title')}</h2>
          <span>${t('sample.ready')}</span>
        </div>
        <div class="sample-cards">
          ${sampleCard(props, 'slow-dance')}${sampleCard(props, 'walk')}
        </div>
      </section>
    </div>
    <footer class="empty-foot">
      <span>${t('empty.offline')}</span><span>${t('empty.method')}</span>
    </footer>
  `;
}
