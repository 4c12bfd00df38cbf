/** The side panel: result, recording, notes, body; below them, always in sight, what can be taken away. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Clip } from '../app/clips';
import type { DecisionKey } from '../app/decisions';
import type { Words } from '../app/i18n/catalogue';
import { icon } from '../common/icons';
import type { Decisions, ExportKind } from '../engine/types';
import { bodySection } from './body';
import { notesSection } from './notes';
import { recordingSection } from './recording';
import { resultSection } from './result';

export interface InspectorProps {
  readonly words: Words;
  readonly clip: Clip;
  readonly performerIndex: number;
  readonly onDecide: (key: DecisionKey, value: Decisions[DecisionKey] | undefined) => void;
  readonly onPerformer: (index: number) => void;
  readonly onFrame: (frame: number) => void;
  readonly onExport: (kind: ExportKind) => void;
}

function exportFooter({ words: { t }, clip, onExport }: InspectorProps): TemplateResult {
  const button = (kind: ExportKind, key: 'export.csv' | 'export.json'): TemplateResult =>
    html`<button
      type="button"
      class="button line"
      data-tip=${t(`${key}.about`)}
      ?disabled=${clip.outdated}
      @click=${() => onExport(kind)}
    >
      ${icon('download', 14)}${t(key)}
    </button>`;
  return html`<section class="inspector-foot" aria-label=${t('export.title')}>
    <h3>${t('export.title')}</h3>
    <div class="export-buttons">
      ${button('keyposes-csv', 'export.csv')}${button('keyposes-json', 'export.json')}
    </div>
  </section>`;
}

export function inspector(props: InspectorProps): TemplateResult | typeof nothing {
  const { words, clip, performerIndex } = props;
  const { result } = clip;
  const performer = result?.performers[performerIndex];
  if (!result || !performer) return nothing;
  const notes = [...result.notes, ...performer.notes];
  return html`
    <div class="inspector-sections">
      ${resultSection(words, performer, clip.outdated)}
      ${recordingSection({ ...props, result, performer })}
      ${notesSection(words, notes, props.onFrame)} ${bodySection(words, performer)}
    </div>
    ${exportFooter(props)}
  `;
}
