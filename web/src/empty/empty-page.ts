/** The page before there is anything: what it does, where to drop files, samples to try. */
import { html, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { icon } from '../common/icons';
import { hero } from './hero';
import { sampleCard } from './sample-card';
import { sampleMotions, type SamplePicture } from './sample-picture';

export interface EmptyProps {
  readonly words: Words;
  readonly pictures: readonly SamplePicture[];
  /** Of the drop zone, in pixels. */
  readonly width: number;
  readonly onFiles: () => void;
  readonly onFolder: () => void;
  readonly onSample: (id: string) => void;
}

function pictureOf(
  pictures: readonly SamplePicture[],
  motion: SamplePicture['motion'],
): SamplePicture | null {
  return pictures.find((picture) => picture.motion === motion) ?? null;
}

function samples({ words, pictures, onSample }: EmptyProps): TemplateResult {
  const { t } = words;
  return html`<section class="samples" aria-label=${t('sample.title')}>
    <div class="samples-head">
      <h2>${t('sample.title')}</h2>
      <span>${t('sample.ready')}</span>
    </div>
    <div class="sample-cards">
      ${sampleMotions.map((motion) =>
        sampleCard(motion, pictureOf(pictures, motion), words, () => onSample(motion)),
      )}
    </div>
  </section>`;
}

export function emptyPage(props: EmptyProps): TemplateResult {
  const { words, pictures, width, onFiles, onFolder } = props;
  const { t } = words;
  return html`
    <div class="empty-column">
      <h1>${t('empty.title')}</h1>
      <div class="drop-zone">
        <svg class="drop-edge" aria-hidden="true"><rect x="1" y="1" rx="15" /></svg>
        ${hero(pictureOf(pictures, 'slow-dance'), words, width)}
        <p class="drop-sentence">${t('empty.drop')}</p>
        <div class="drop-buttons">
          <button type="button" class="button primary big" @click=${onFiles}>
            ${icon('file-up', 17)}${t('empty.files')}
          </button>
          <button type="button" class="button line big" @click=${onFolder}>
            ${icon('folder-open', 17)}${t('empty.folder')}
          </button>
        </div>
        <p class="drop-private">${icon('lock', 15)}${t('empty.private')}</p>
      </div>
      ${samples(props)}
    </div>
    <footer class="empty-foot">
      <span>${t('empty.offline')}</span><span>${t('empty.method')}</span>
    </footer>
  `;
}
