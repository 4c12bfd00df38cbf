/** How the clips are shown and run together in; the bar over the stages out. */
import { html, type TemplateResult } from 'lit-html';
import type { Synchronisation } from '../app/compare-store';
import type { Words } from '../app/i18n/catalogue';
import { icon, type IconName } from '../common/icons';
import { segments } from './segments';

export interface PairBarProps {
  readonly words: Words;
  readonly superposed: boolean;
  readonly synchronisation: Synchronisation;
  readonly mirrorB: boolean;
  readonly keyposes: boolean;
  readonly follow: boolean;
  readonly onSuperpose: (superposed: boolean) => void;
  readonly onSynchronise: (way: Synchronisation) => void;
  readonly onMirror: () => void;
  readonly onKeyposes: () => void;
  readonly onFollow: () => void;
}

const ways: readonly Synchronisation[] = ['start', 'keypose', 'warp'];

function toggle(
  name: IconName,
  label: string,
  on: boolean,
  tip: string,
  onPress: () => void,
): TemplateResult {
  return html`<button
    type="button"
    class="button ghost ${on ? 'on' : ''}"
    aria-pressed=${String(on)}
    data-tip=${tip}
    @click=${onPress}
  >
    ${icon(name, 15)}<span class="pair-toggle-name">${label}</span>
  </button>`;
}

export function pairBar(props: PairBarProps): TemplateResult {
  const { t } = props.words;
  const { superposed, synchronisation, onSuperpose, onSynchronise } = props;
  return html`
    ${segments(t('pair.layout'), [
      {
        label: t('pair.side-by-side'),
        icon: 'columns-2',
        chosen: !superposed,
        onChoose: () => onSuperpose(false),
      },
      {
        label: t('pair.superposed'),
        icon: 'layers-2',
        chosen: superposed,
        onChoose: () => onSuperpose(true),
      },
    ])}
    <span class="rule"></span>
    <span class="pair-bar-name" aria-hidden="true">${t('pair.synchronise')}</span>
    ${segments(
      t('pair.synchronise'),
      ways.map((way) => ({
        label: t(`pair.by.${way}`),
        tip: t(`pair.by.${way}.about`),
        chosen: way === synchronisation,
        onChoose: () => onSynchronise(way),
      })),
    )}
    <span class="pair-bar-gap"></span>
    ${toggle('flip-horizontal-2', t('pair.mirror'), props.mirrorB, t('pair.mirror.about'), props.onMirror)}
    ${toggle('ghost', t('pair.keyposes'), props.keyposes, t('pair.keyposes.about'), props.onKeyposes)}
    ${toggle('focus', t('stage.follow'), props.follow, t('stage.follow'), props.onFollow)}
  `;
}
