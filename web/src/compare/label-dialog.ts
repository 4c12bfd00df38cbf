/**
 * The panel that labels by file name: a pattern in, what it would do shown while it is written; the rule
 * set when it is applied. It floats and closes by Escape: undo covers what it does.
 */
import { computed, signal, type ReadonlySignal, type Signal } from '@preact/signals-core';
import { html, nothing, type TemplateResult } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import type { Context } from '../app/context';
import type { Words } from '../app/i18n/catalogue';
import { keptBeside } from '../common/beside';
import { iconButton } from '../common/buttons';
import { clipName } from '../common/clip-name';
import { icon } from '../common/icons';
import { labelPreview, type LabelExample, type LabelPreview } from './label-preview';

const panelId = 'label-panel';
const usualPattern = '{label}_*';

export interface LabelDialog {
  readonly template: () => TemplateResult;
}

interface Draft {
  readonly pattern: Signal<string>;
  readonly preview: ReadonlySignal<LabelPreview>;
}

const panel = (): HTMLElement | null => document.getElementById(panelId);

export function openLabelDialog(): void {
  panel()?.showPopover();
}

const close = (): void => panel()?.hidePopover();

const underLabels = keptBeside({ opens: 'labels-menu', side: 'below', edge: 'left' });

function example({ t }: Words, { name, label }: LabelExample): TemplateResult {
  return html`<tr>
    <td>${clipName(name)}</td>
    <td class=${label === null ? 'quiet' : 'label-found'}>${label ?? t('names.no-label')}</td>
  </tr>`;
}

function previewTable(words: Words, preview: LabelPreview): TemplateResult {
  const { t } = words;
  if (preview.fault !== null)
    return html`<p class="label-fault" role="alert">
      ${icon('info', 14)}<span>${t(`labels.fault.${preview.fault}`)}</span>
    </p>`;
  const total = preview.matched + preview.unmatched;
  return html`<p class="label-count">
      ${t('labels.matched', preview.matched, total)} ${t('labels.distinct', preview.labels)}
    </p>
    <table class="label-examples">
      <caption class="spoken">
        ${t('labels.examples')}
      </caption>
      <tbody>
        ${preview.examples.map((one) => example(words, one))}
      </tbody>
    </table>
    ${preview.unmatched > 0 ? html`<p class="quiet">${t('labels.unmatched', preview.unmatched)}</p>` : nothing}`;
}

function form(words: Words, draft: Draft, onApply: () => void): TemplateResult {
  const { t } = words;
  const preview = draft.preview.value;
  const onInput = (event: Event): void => {
    draft.pattern.value = (event.target as HTMLInputElement).value;
  };
  const onSubmit = (event: Event): void => {
    event.preventDefault();
    // What has been written since the last drawing counts too.
    if (draft.preview.peek().fault === null) onApply();
  };
  // The button may still be barred from before the last letter, and then Enter would submit nothing.
  const onKey = (event: KeyboardEvent): void => {
    if (event.key === 'Enter' && !event.isComposing) onSubmit(event);
  };
  return html`<form class="label-form" @submit=${onSubmit}>
    <label for="label-pattern">${t('labels.pattern-field')}</label>
    <div class="field">
      <input
        id="label-pattern"
        type="text"
        autocomplete="off"
        spellcheck="false"
        autofocus
        aria-describedby="label-about"
        aria-invalid=${String(preview.fault !== null)}
        .value=${live(draft.pattern.value)}
        @input=${onInput}
        @keydown=${onKey}
      />
    </div>
    <p id="label-about" class="quiet">${t('labels.about')}</p>
    <div class="label-preview">${previewTable(words, preview)}</div>
    <div class="label-buttons">
      <button type="button" class="button line" @click=${close}>${t('labels.cancel')}</button>
      <button type="submit" class="button primary" ?disabled=${preview.fault !== null}>
        ${t('labels.apply')}
      </button>
    </div>
  </form>`;
}

export function createLabelDialog({ store, compareActions, language }: Context): LabelDialog {
  const pattern = signal(usualPattern);
  // The names are gone through only while somebody looks.
  const isOpen = signal(false);
  const draft = {
    pattern,
    preview: computed(() => labelPreview(pattern.value, isOpen.value ? store.present.value : [])),
  };
  const onToggle = (event: Event): void => {
    const element = event.currentTarget as HTMLElement;
    isOpen.value = element.matches(':popover-open');
    if (!isOpen.peek()) return;
    const rule = store.compare.labelRule.peek();
    pattern.value = rule.kind === 'pattern' ? rule.pattern : usualPattern;
  };
  const apply = (): void => {
    compareActions.setLabelRule({ kind: 'pattern', pattern: pattern.peek() });
    close();
  };
  return {
    template: () => popover(language.words.value, onToggle, (words) => form(words, draft, apply)),
  };
}

function popover(
  words: Words,
  onToggle: (event: Event) => void,
  content: (words: Words) => unknown,
): TemplateResult {
  const title = words.t('labels.from-names');
  return html`<div
    id=${panelId}
    class="form-panel label-panel"
    popover
    role="dialog"
    aria-label=${title}
    @beforetoggle=${underLabels}
    @toggle=${onToggle}
  >
    <div class="dialog-head">
      <h2>${title}</h2>
      ${iconButton({ name: 'x', label: words.t('help.close'), onPress: close })}
    </div>
    ${content(words)}
  </div>`;
}
