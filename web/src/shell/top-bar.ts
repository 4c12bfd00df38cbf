/** Where one is and what holds everywhere: the mark, the open clip and its neighbours, undo, taste, help. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Page } from '../app/compare-store';
import type { Words } from '../app/i18n/catalogue';
import type { ThemeChoice } from '../app/theme';
import { mark, type IconName } from '../common/icons';
import { iconButton } from '../common/buttons';
import { clipName } from '../common/clip-name';
import { labelMark } from '../common/label-mark';
import { menuButton } from '../common/menu';

export interface OpenClipPlace {
  readonly name: string;
  readonly qualifier: string;
  /** Its place among all labels; null without one. */
  readonly label: { readonly name: string; readonly place: number } | null;
  /** From 1, among the rows shown; 0 where the filter hides the clip. */
  readonly place: number;
  readonly count: number;
}

export interface TopBarProps {
  readonly words: Words;
  readonly themeChoice: ThemeChoice;
  /** null on the empty page. */
  readonly study: {
    readonly page: Page;
    readonly clip: OpenClipPlace | null;
    readonly undo: string | null;
    readonly redo: string | null;
    /** Whether there are side panels at all. */
    readonly panels: boolean;
    readonly libraryOpen: boolean;
    /** null where there is nothing to show in it. */
    readonly inspectorOpen: boolean | null;
  } | null;
  readonly onPage: (page: Page) => void;
  readonly onClip: (direction: 1 | -1) => void;
  readonly onUndo: () => void;
  readonly onRedo: () => void;
  readonly onLanguage: () => void;
  readonly onTheme: () => void;
  readonly onHelp: () => void;
  readonly onLibrary: () => void;
  readonly onInspector: () => void;
}

const themeIcons: Readonly<Record<ThemeChoice, IconName>> = {
  light: 'sun',
  dark: 'moon',
  system: 'sun-moon',
};

function clipPlace({ words: { t }, onClip }: TopBarProps, clip: OpenClipPlace): TemplateResult {
  return html`
    ${iconButton({ name: 'chevron-left', label: t('top.previous-clip'), small: true, disabled: clip.place <= 1, onPress: () => onClip(-1) })}
    <h1 class="top-clip">${clipName(clip.name, clip.qualifier)}</h1>
    ${clip.label === null ? nothing : html`<span class="top-label" title=${clip.label.name}>${labelMark(clip.label.place)}<span>${clip.label.name}</span></span>`}
    <span class="top-place"
      >${clip.place > 0 ? t('top.place', clip.place, clip.count) : nothing}</span
    >
    ${iconButton({ name: 'chevron-right', label: t('top.next-clip'), small: true, disabled: clip.place === 0 || clip.place >= clip.count, onPress: () => onClip(1) })}
  `;
}

const pages: readonly Page[] = ['study', 'compare', 'pair'];

function pageTabs({ words: { t }, onPage }: TopBarProps, current: Page): TemplateResult {
  const tab = (page: Page): TemplateResult =>
    html`<button
      class="page-tab"
      aria-current=${page === current ? 'page' : nothing}
      @click=${() => onPage(page)}
    >
      ${t(`top.page.${page}`)}
    </button>`;
  return html`<nav class="page-tabs" aria-label=${t('top.pages')}>${pages.map(tab)}</nav>`;
}

function historyButtons(
  props: TopBarProps,
  study: NonNullable<TopBarProps['study']>,
): TemplateResult {
  const { t } = props.words;
  const { undo, redo } = study;
  return html`
    ${iconButton({ name: 'undo', label: undo === null ? t('top.undo') : t('top.undo.what', undo), keys: 'Control+Z', keyText: `${t('key.ctrl')} Z`, disabled: undo === null, onPress: props.onUndo })}
    ${iconButton({ name: 'redo', label: redo === null ? t('top.redo') : t('top.redo.what', redo), keys: 'Control+Shift+Z', keyText: `${t('key.ctrl')} ${t('key.shift')} Z`, disabled: redo === null, onPress: props.onRedo })}
    <span class="rule"></span>
  `;
}

const otherLanguage = ({ words }: TopBarProps): string => (words.language === 'en' ? 'ja' : 'en');

/** The same in a menu, for narrow windows. */
function tasteMenu(props: TopBarProps): TemplateResult {
  const { t } = props.words;
  return html`<span class="top-more"
    >${menuButton({
      id: 'more-menu',
      name: 'ellipsis',
      label: t('top.more'),
      items: [
        { label: t('language.other'), lang: otherLanguage(props), onChoose: props.onLanguage },
        {
          label: t(`top.theme.${props.themeChoice}`),
          icon: themeIcons[props.themeChoice],
          onChoose: props.onTheme,
        },
        { label: t('top.help'), icon: 'help', onChoose: props.onHelp },
      ],
    })}</span
  >`;
}

function tasteButtons(props: TopBarProps): TemplateResult {
  const { t } = props.words;
  return html`
    <button class="button ghost language" lang=${otherLanguage(props)} @click=${props.onLanguage}>
      ${t('language.other')}
    </button>
    ${iconButton({ name: themeIcons[props.themeChoice], label: t(`top.theme.${props.themeChoice}`), onPress: props.onTheme })}
    ${iconButton({ name: 'help', label: t('top.help'), keys: '?', keyText: '?', onPress: props.onHelp })}
  `;
}

export function topBar(props: TopBarProps): TemplateResult {
  const {
    words: { t },
    study,
  } = props;
  const panel = (name: IconName, label: string, on: boolean, onPress: () => void): TemplateResult =>
    iconButton({ name, label, expanded: on, onPress });
  return html`
    <div class="top-lead">
      <div class="brand">${mark()}<span>Keypose</span></div>
      ${study?.panels && study.page !== 'pair' ? panel('panel-left', t('top.library'), study.libraryOpen, props.onLibrary) : nothing}
    </div>
    ${study?.panels ? pageTabs(props, study.page) : nothing}
    <div id="top-middle" class="top-middle">
      ${study?.clip && study.page === 'study' ? clipPlace(props, study.clip) : nothing}
    </div>
    <div class="top-end">
      ${study ? historyButtons(props, study) : nothing}
      <span class="top-taste">${tasteButtons(props)}</span>
      ${study ? tasteMenu(props) : nothing}
      ${study?.panels && study.inspectorOpen !== null ? html`<span class="rule"></span>${panel('panel-right', t('top.inspector'), study.inspectorOpen, props.onInspector)}` : nothing}
    </div>
  `;
}
