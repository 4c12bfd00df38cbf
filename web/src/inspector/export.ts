/** What can be taken away as files: keyposes, candidates, traces, each as CSV and as JSON. */
import { html, type TemplateResult } from 'lit-html';
import type { Clip } from '../app/clips';
import type { Words } from '../app/i18n/catalogue';
import { icon } from '../common/icons';
import type { ExportKind } from '../engine/types';
import { section } from './section';

export interface ExportProps {
  readonly words: Words;
  readonly clip: Clip;
  readonly onExport: (kind: ExportKind) => void;
}

const contents = ['keyposes', 'candidates', 'traces'] as const;
const forms = ['csv', 'json'] as const;

/** What is typed, as `--csv`, stays in one piece. */
const withCommands = (text: string): unknown[] =>
  text
    .split(/(keypose keyposes|--[a-z]+)/)
    .map((piece, index) => (index % 2 === 1 ? html`<code>${piece}</code>` : piece));

export function exportSection({ words: { t }, clip, onExport }: ExportProps): TemplateResult {
  const button = (
    content: (typeof contents)[number],
    form: (typeof forms)[number],
  ): TemplateResult =>
    html`<button
      type="button"
      class="button line"
      aria-label=${t('export.what', t(`export.${content}`), form.toUpperCase())}
      ?disabled=${clip.outdated}
      @click=${() => onExport(`${content}-${form}`)}
    >
      ${icon('download', 14)}${form.toUpperCase()}
    </button>`;
  const row = (content: (typeof contents)[number]): TemplateResult =>
    html`<li class="export">
      <div>
        <h4>${t(`export.${content}`)}</h4>
        <p>${t(`export.${content}.about`)}</p>
      </div>
      <div class="button-row">${forms.map((form) => button(content, form))}</div>
    </li>`;
  return section({
    label: t('export.title'),
    beside: clip.outdated ? t('result.updating') : '',
    body: html`<ul class="exports">
        ${contents.map(row)}
      </ul>
      <p class="quiet">${withCommands(t('export.same'))}</p>`,
  });
}
