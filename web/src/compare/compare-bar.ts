/** The bar of the page: distance, tree and labels chosen from menus; what was found saved as files. */
import '../styles/compare-bar.css';
import { html, type TemplateResult } from 'lit-html';
import type { LabelRule } from '../app/compare-store';
import type { Context } from '../app/context';
import type { MessageKey, Words } from '../app/i18n/catalogue';
import { menuButton, type Menu, type MenuItem } from '../common/menu';
import { mount } from '../common/mount';
import {
  measures,
  type ComparisonExportKind,
  type ComparisonSettings,
  type Linkage,
} from '../engine/comparison-types';
import { fileProgress } from './file-progress';
import { saveComparePicture, type PictureFormat, type PictureKind } from './pictures';
import { createLabelDialog, openLabelDialog } from './label-dialog';
import { createSetFiles, type FileUnderWay, type SetFiles } from './set-files';

interface BarProps {
  readonly words: Words;
  readonly settings: ComparisonSettings;
  readonly rule: LabelRule;
  readonly byHand: boolean;
  /** Why a kind of file cannot be written. */
  readonly barred: Readonly<Record<'comparison' | 'evaluation', string | undefined>>;
  /** A file of the set that is being written. */
  readonly file: FileUnderWay | null;
  readonly onSettings: (settings: ComparisonSettings) => void;
  readonly onRule: (rule: LabelRule) => void;
  readonly onPattern: () => void;
  readonly onHand: () => void;
  readonly onExport: (kind: ComparisonExportKind) => void;
  readonly onCancelFile: () => void;
  readonly onPicture: (kind: PictureKind, format: PictureFormat) => void;
}

const linkages: readonly Linkage[] = ['ward', 'average'];

function distanceMenu({ words: { t }, settings, onSettings }: BarProps): Menu {
  const { distance } = settings;
  const kinds = measures.map((measure) => ({
    label: t(`measure.${measure}`),
    checked: measure === distance.measure,
    onChoose: () => onSettings({ ...settings, distance: { ...distance, measure } }),
  }));
  const option = (key: 'mirrorAware' | 'acrossRigs', label: MessageKey): MenuItem => ({
    label: t(label),
    checked: distance[key],
    several: true,
    apart: key === 'mirrorAware',
    onChoose: () => onSettings({ ...settings, distance: { ...distance, [key]: !distance[key] } }),
  });
  const options = [
    option('mirrorAware', 'bar.mirror-aware'),
    option('acrossRigs', 'bar.across-rigs'),
  ];
  const chosen = options.filter(({ checked }) => checked).map(({ label }) => label.toLowerCase());
  return {
    id: 'distance-menu',
    name: 'chevron-down',
    field: true,
    label: t('bar.distance'),
    text: [t(`measure.${distance.measure}`), ...chosen].join(t('bar.and')),
    items: [...kinds, ...options],
  };
}

function treeMenu({ words: { t }, settings, onSettings }: BarProps): Menu {
  const item = (linkage: Linkage): MenuItem => ({
    label: t(`linkage.${linkage}`),
    checked: linkage === settings.linkage,
    barred:
      linkage === 'ward' && settings.distance.mirrorAware ? t('linkage.ward.barred') : undefined,
    onChoose: () => onSettings({ ...settings, linkage }),
  });
  return {
    id: 'tree-menu',
    name: 'chevron-down',
    field: true,
    label: t('bar.tree'),
    text: t(`linkage.${settings.linkage}`),
    items: linkages.map(item),
  };
}

const isKind = (rule: LabelRule, kind: LabelRule['kind']): boolean => rule.kind === kind;

function labelMenu(props: BarProps): Menu {
  const { words, rule, byHand, onRule } = props;
  const { t } = words;
  const source = rule.kind === 'none' && byHand ? 'hand' : rule.kind;
  return {
    id: 'labels-menu',
    name: 'tag',
    field: true,
    label: t('bar.labels'),
    text: t(`labels.${source}`),
    items: [
      {
        label: t('labels.folder'),
        checked: isKind(rule, 'folder'),
        onChoose: () => onRule({ kind: 'folder' }),
      },
      {
        label: t('labels.pattern.choose'),
        checked: isKind(rule, 'pattern'),
        onChoose: props.onPattern,
      },
      {
        label: t('labels.none'),
        checked: isKind(rule, 'none'),
        onChoose: () => onRule({ kind: 'none' }),
      },
      { label: t('labels.hand.choose'), apart: true, onChoose: props.onHand },
    ],
  };
}

const exportKinds: readonly (readonly ComparisonExportKind[])[] = [
  ['features-csv', 'features-npy', 'matrix-csv', 'matrix-npy', 'tree-newick'],
  ['evaluation-csv', 'evaluation-json'],
];

const pictureKinds: readonly PictureKind[] = ['matrix', 'tree', 'map'];
const pictureFormats: readonly PictureFormat[] = ['svg', 'png'];

function fileItems({ words: { t }, barred, file, onExport }: BarProps): MenuItem[] {
  const busy = file ? t('save.busy', file.fileName) : undefined;
  const item = (kind: ComparisonExportKind, apart: boolean): MenuItem => ({
    label: t(`save.${kind}`),
    apart,
    barred:
      busy ?? barred.comparison ?? (kind.startsWith('evaluation') ? barred.evaluation : undefined),
    onChoose: () => onExport(kind),
  });
  return exportKinds.flatMap((kinds, group) =>
    kinds.map((kind, index) => item(kind, group > 0 && index === 0)),
  );
}

function pictureItems({ words: { t }, barred, onPicture }: BarProps): MenuItem[] {
  return pictureKinds.flatMap((kind, group) =>
    pictureFormats.map((format, index) => ({
      label: t(`save.picture.${kind}`, format.toUpperCase()),
      apart: group + index === 0,
      barred: barred.comparison,
      onChoose: () => onPicture(kind, format),
    })),
  );
}

function exportMenu(props: BarProps): Menu {
  const label = props.words.t('bar.export');
  return {
    id: 'save-menu',
    name: 'download',
    label,
    text: label,
    items: [...fileItems(props), ...pictureItems(props)],
  };
}

function bar(props: BarProps): TemplateResult {
  const menus = [distanceMenu(props), treeMenu(props), labelMenu(props)];
  return html`${menus.map(
      (menu) =>
        html`<span class="bar-label" aria-hidden="true">${menu.label}</span>${menuButton(menu)}`,
    )}<span class="bar-gap"></span
    >${fileProgress(props.words, props.file, props.onCancelFile)}${menuButton(exportMenu(props))}`;
}

function propsOf(context: Context, files: SetFiles): BarProps {
  const { store, compareActions, language } = context;
  const words = language.words.value;
  const { settings, labelRule, handLabels, comparison, evaluation } = store.compare;
  return {
    words,
    settings: settings.value,
    rule: labelRule.value,
    byHand: [...handLabels.value.values()].some(Boolean),
    barred: {
      comparison: comparison.value ? undefined : words.t('save.nothing'),
      evaluation: evaluation.value ? undefined : words.t('save.no-labels'),
    },
    file: files.underWay.value,
    onSettings: (next) => compareActions.setComparisonSettings(next),
    onRule: (rule) => compareActions.setLabelRule(rule),
    onPattern: openLabelDialog,
    onHand: () => compareActions.setTab('table'),
    onExport: (kind) => void files.save(kind),
    onCancelFile: files.cancel,
    onPicture: (kind, format) => void saveComparePicture(context, kind, format),
  };
}

export function mountCompareBar(place: HTMLElement, context: Context): void {
  const dialog = createLabelDialog(context);
  const files = createSetFiles(context);
  place.classList.add('compare-bar');
  place.setAttribute('role', 'group');
  mount(place, () => {
    place.setAttribute('aria-label', context.language.words.value.t('bar.name'));
    return html`${bar(propsOf(context, files))}${dialog.template()}`;
  });
}
