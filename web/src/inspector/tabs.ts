/** The tabs of the side panel: the chosen one in; another by press, arrow keys, Home or End out. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import type { InspectorTab } from '../app/store';

export const inspectorTabs: readonly InspectorTab[] = ['method', 'body', 'doctor', 'export'];

export const tabId = (tab: InspectorTab): string => `inspector-tab-${tab}`;
export const panelId = (tab: InspectorTab): string => `inspector-panel-${tab}`;

export interface TabsProps {
  readonly words: Words;
  readonly chosen: InspectorTab;
  readonly notes: number;
  readonly onTab: (tab: InspectorTab) => void;
}

/** The tab that a key leads to; null for other keys. */
export function tabByKey(key: string, chosen: InspectorTab): InspectorTab | null {
  const last = inspectorTabs.length - 1;
  const index = inspectorTabs.indexOf(chosen);
  const next = { ArrowLeft: index - 1, ArrowRight: (index + 1) % (last + 1), Home: 0, End: last }[
    key
  ];
  return next === undefined ? null : (inspectorTabs.at(next) ?? null);
}

/** After a press of the pointer the keys go on to play the motion, as everywhere on the page. */
const reach = { pressed: false, byPointer: false };

function press(): void {
  reach.pressed = true;
  reach.byPointer = true;
}

function focus(): void {
  reach.byPointer = reach.pressed;
  reach.pressed = false;
}

export function tabList({ words: { t, format }, chosen, notes, onTab }: TabsProps): TemplateResult {
  const onKey = (event: KeyboardEvent): void => {
    if (reach.byPointer || event.ctrlKey || event.altKey || event.metaKey) return;
    // The focus tells the tab: two keys may come before the panel is drawn again.
    const focused = inspectorTabs.find((one) => tabId(one) === (event.target as Element).id);
    const tab = tabByKey(event.key, focused ?? chosen);
    if (!tab) return;
    event.preventDefault();
    onTab(tab);
    document.getElementById(tabId(tab))?.focus();
  };
  const tab = (name: InspectorTab): TemplateResult => {
    const count = name === 'doctor' && notes > 0;
    return html`<button
      type="button"
      id=${tabId(name)}
      class="tab"
      role="tab"
      aria-selected=${String(name === chosen)}
      aria-controls=${panelId(name)}
      tabindex=${name === chosen ? 0 : -1}
      data-tip=${count ? t('library.notes', notes) : nothing}
      @click=${() => {
        reach.pressed = false;
        onTab(name);
      }}
    >
      ${t(`tab.${name}`)}${count ? html`<span class="tab-count">${format.integer(notes)}</span>` : nothing}
    </button>`;
  };
  return html`<div
    class="tabs"
    role="tablist"
    aria-label=${t('inspector.label')}
    @keydown=${onKey}
    @pointerdown=${press}
    @focusin=${focus}
  >
    ${inspectorTabs.map(tab)}
  </div>`;
}
