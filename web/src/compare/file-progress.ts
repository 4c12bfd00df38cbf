/** How far a file is in; its progress out, with what ends it. A file that is done at once shows none. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import { estimateSecondsLeft, timeLeftText } from '../app/time-left';
import { icon } from '../common/icons';
import type { FileUnderWay } from './set-files';

const shownFromS = 0.3;

export function fileProgress(
  words: Words,
  file: FileUnderWay | null,
  onCancel: () => void,
): TemplateResult | typeof nothing {
  if (!file || file.elapsedS < shownFromS) return nothing;
  const { t, format } = words;
  const { fileName, done, elapsedS } = file;
  const left = timeLeftText(words, estimateSecondsLeft(elapsedS, done, 1));
  return html`<div class="file-progress" role="group" aria-label=${fileName}>
    <div class="file-facts">
      <span class="file-name">${fileName}</span>
      <span>${t('unit.percent', format.integer(Math.floor(100 * done)))}</span>
      <span class="file-left">${left}</span>
      <progress class="bar" max="1" .value=${done} aria-label=${fileName}></progress>
    </div>
    <button
      type="button"
      class="button line"
      aria-label=${t('save.cancel.file', fileName)}
      @click=${onCancel}
    >
      ${icon('x', 14)}<span>${t('save.cancel')}</span>
    </button>
  </div>`;
}
