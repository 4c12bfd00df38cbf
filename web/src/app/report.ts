/** How a batch of files ended in; the one thing that has to be said about it out, if there is one. */
import type { ClipId } from '../engine/types';
import type { Words } from './i18n/catalogue';
import type { BatchReport } from './loading';
import type { Store, Toast } from './store';

type OpenClip = (id: ClipId) => void;

function failedToast(
  report: BatchReport,
  store: Store,
  { t }: Words,
  openClip: OpenClip,
): Toast | null {
  const [first] = report.failed;
  if (first === undefined || (report.clips.length === 1 && store.openId.peek() === first))
    return null;
  const name = store.clips.peek()[first]?.source.name ?? '';
  const text =
    report.failed.length === 1
      ? t('toast.failed.one', name)
      : t('toast.failed', report.failed.length, report.clips.length);
  return { kind: 'error', text, action: { label: t('toast.show'), run: () => openClip(first) } };
}

function otherToast({ others }: BatchReport, { t }: Words): Toast | null {
  const [first] = others;
  if (first === undefined) return null;
  const text =
    others.length === 1 ? t('toast.not-bvh', first) : t('toast.not-bvh.many', others.length, first);
  return { kind: 'error', text };
}

function archiveToast({ archives }: BatchReport, { t, failure }: Words): Toast | null {
  const [first] = archives;
  return first
    ? { kind: 'error', text: t('toast.error', first.name, failure(first.failure)) }
    : null;
}

/** The most serious matter of a batch; null where all went well. */
export function toastOfReport(
  report: BatchReport,
  store: Store,
  words: Words,
  openClip: OpenClip,
): Toast | null {
  const { t } = words;
  if (report.cancelled)
    return { kind: 'info', text: t('toast.cancelled', store.present.peek().length) };
  const problem =
    archiveToast(report, words) ??
    failedToast(report, store, words, openClip) ??
    otherToast(report, words);
  if (problem) return problem;
  const [empty] = report.emptyFolders;
  if (empty !== undefined) return { kind: 'error', text: t('toast.nothing-found', empty) };
  return report.known.length > 0
    ? { kind: 'info', text: t('toast.already', report.known.length) }
    : null;
}
