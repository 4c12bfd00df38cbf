/** The side panel: tabs, whose motion it is where there are several, and what the chosen tab holds. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { InspectorTab } from '../app/store';
import type { ClipResult } from '../engine/types';
import { performerLetter } from '../figure/performer-letter';
import { body, type BodyProps } from './body';
import { doctor, type DoctorProps } from './doctor';
import { exportSection, type ExportProps } from './export';
import { methodSection, type MethodProps } from './method';
import { resultSection } from './result';
import { choiceField, settingRow } from './setting-row';
import { inspectorTabs, panelId, tabId, tabList } from './tabs';
import { whySection, type WhyProps } from './why';

export interface InspectorProps
  extends
    BodyProps,
    DoctorProps,
    ExportProps,
    Omit<MethodProps, 'defaults'>,
    Omit<WhyProps, 'frameTimeS' | 'outdated'> {
  readonly defaults: MethodProps['defaults'] | null;
  readonly result: ClipResult;
  readonly tab: InspectorTab;
  readonly onTab: (tab: InspectorTab) => void;
  readonly onPerformer: (index: number) => void;
}

function method(props: InspectorProps): TemplateResult {
  const { words, performer, clip, result, defaults } = props;
  const why = { ...props, frameTimeS: result.frameTimeS, outdated: clip.outdated };
  return html`${defaults ? methodSection({ ...props, defaults }) : nothing}
  ${resultSection(words, performer, clip.outdated)} ${whySection(why)}`;
}

const contents: Readonly<Record<InspectorTab, (props: InspectorProps) => TemplateResult>> = {
  method,
  body,
  doctor,
  export: exportSection,
};

function performerChoice(props: InspectorProps): TemplateResult | typeof nothing {
  const {
    words: { t },
    result,
    performerIndex,
    onPerformer,
  } = props;
  if (result.performers.length < 2) return nothing;
  const control = choiceField({
    id: 'performer',
    value: String(performerIndex),
    options: result.performers.map((_, index) => [
      String(index),
      t('recording.performer.number', performerLetter(index)),
    ]),
    onValue: (value) => onPerformer(Number(value)),
  });
  return html`<div class="performer-choice">
    ${settingRow({ id: 'performer', label: t('recording.performer'), reset: null, control })}
  </div>`;
}

export function inspector(props: InspectorProps): TemplateResult {
  const { words, tab: chosen, notes, onTab } = props;
  const panel = (tab: InspectorTab): TemplateResult =>
    html`<div
      id=${panelId(tab)}
      class="inspector-panel"
      role="tabpanel"
      aria-labelledby=${tabId(tab)}
      ?hidden=${tab !== chosen}
    >
      ${tab === chosen ? contents[tab](props) : nothing}
    </div>`;
  return html`${tabList({ words, chosen, notes: notes.length, onTab })} ${performerChoice(props)}
  ${inspectorTabs.map(panel)}`;
}
