/** What goes wrong where nobody waits for it in; a sentence on the page out, which itself goes on. */
import type { Context } from '../app/context';

/** A browser's own remark, no error: sizes that were watched changed once more. */
const harmless = /^ResizeObserver loop/;

export function tellErrors(target: Window, { store, language }: Context): void {
  const tell = (message: string): void => {
    if (harmless.test(message)) return;
    const { t } = language.words.peek();
    store.toast.value = { kind: 'error', text: t('toast.page-error', message) };
  };
  target.addEventListener('error', ({ message }) => tell(message));
  target.addEventListener('unhandledrejection', ({ reason }) => {
    tell(reason instanceof Error ? reason.message : String(reason));
  });
}
