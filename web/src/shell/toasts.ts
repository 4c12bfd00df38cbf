/** Bottom left: how far the reading is, and the one thing that was just done or went wrong. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Words } from '../app/i18n/catalogue';
import type { LoadingState, Toast } from '../app/store';
import { timeLeftText } from '../app/time-left';
import { iconButton } from '../common/buttons';
import { icon, type IconName } from '../common/icons';

export interface NoticeProps {
  readonly words: Words;
  readonly loading: LoadingState | null;
  readonly toast: Toast | null;
  readonly onCancel: () => void;
  readonly onClose: () => void;
}

const toastIcons: Readonly<Record<Toast['kind'], IconName>> = {
  done: 'circle-check',
  error: 'octagon-x',
  info: 'info',
};

/** What is done to how many files, and to how many of them it is done. */
function progressTexts({ t }: Words, loading: LoadingState): { what: string; done: string } {
  const { stage, total, done, failed, searching } = loading;
  if (stage === 'keyposes') {
    return { what: t('progress.keyposes', total), done: t('progress.found', done) };
  }
  const problems = failed > 0 ? `, ${t('progress.problems', failed)}` : '';
  const what = searching && total === 0 ? t('progress.searching') : t('progress.reading', total);
  return { what, done: `${t('progress.read', done)}${problems}` };
}

function progressCard({ words, onCancel }: NoticeProps, loading: LoadingState): TemplateResult {
  const { t } = words;
  const { what, done } = progressTexts(words, loading);
  return html`<section class="notice progress-card" aria-label=${what}>
    <div class="notice-line">
      <strong>${what}</strong>
      ${iconButton({ name: 'x', label: t('progress.cancel'), small: true, onPress: onCancel })}
    </div>
    <progress class="bar" max="1" .value=${loading.fraction} aria-label=${what}></progress>
    <div class="notice-line notice-facts">
      <span>${done}</span>
      <span
        >${loading.searching ? t('progress.searching') : timeLeftText(words, loading.secondsLeft)}</span
      >
    </div>
  </section>`;
}

function toastCard({ words: { t }, onClose }: NoticeProps, toast: Toast): TemplateResult {
  const { action } = toast;
  const run = (): void => {
    onClose();
    action?.run();
  };
  return html`<div class="notice toast toast-${toast.kind}">
    ${icon(toastIcons[toast.kind])}
    <span class="toast-text">${toast.text}</span>
    ${action ? html`<button type="button" class="button link" @click=${run}>${action.label}</button>` : nothing}
    ${toast.kind === 'error' ? iconButton({ name: 'x', label: t('toast.close'), small: true, onPress: onClose }) : nothing}
  </div>`;
}

export function notices(props: NoticeProps): TemplateResult {
  return html`
    ${props.loading ? progressCard(props, props.loading) : nothing}
    <div role="status" aria-live=${props.toast?.kind === 'error' ? 'assertive' : 'polite'}>
      ${props.toast ? toastCard(props, props.toast) : nothing}
    </div>
  `;
}
