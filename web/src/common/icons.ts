/** Names in; icons out: Lucide's (ISC licence) and our own three, drawn once into a sheet of symbols. */
import { html, type TemplateResult } from 'lit-html';
import {
  ArrowDown,
  ArrowUp,
  ArrowUpDown,
  Check,
  ChevronDown,
  ChevronLeft,
  ChevronRight,
  CircleCheck,
  CircleQuestionMark,
  Columns2,
  Copy,
  Download,
  Ellipsis,
  FileUp,
  FlipHorizontal2,
  Focus,
  FolderOpen,
  Gauge,
  Ghost,
  GitFork,
  Image,
  Info,
  Layers2,
  Lock,
  Maximize,
  Minimize,
  Minus,
  Moon,
  OctagonX,
  PanelLeft,
  PanelRight,
  Pause,
  Pencil,
  Play,
  Plus,
  Redo2,
  Repeat,
  Rotate3d,
  RotateCcw,
  Search,
  Spline,
  StepBack,
  StepForward,
  Sun,
  SunMoon,
  Tag,
  TriangleAlert,
  Undo2,
  UnfoldHorizontal,
  Waypoints,
  X,
  ZoomIn,
  ZoomOut,
  type IconNode,
} from 'lucide';

const svgNamespace = 'http://www.w3.org/2000/svg';
const disc = { fill: 'currentColor', stroke: 'none' };

const shapes = {
  'arrow-down': ArrowDown,
  'arrow-up': ArrowUp,
  'arrow-up-down': ArrowUpDown,
  check: Check,
  'chevron-down': ChevronDown,
  'chevron-left': ChevronLeft,
  'chevron-right': ChevronRight,
  'circle-check': CircleCheck,
  'columns-2': Columns2,
  copy: Copy,
  download: Download,
  ellipsis: Ellipsis,
  'file-up': FileUp,
  'flip-horizontal-2': FlipHorizontal2,
  focus: Focus,
  'folder-open': FolderOpen,
  gauge: Gauge,
  ghost: Ghost,
  'git-fork': GitFork,
  image: Image,
  help: CircleQuestionMark,
  info: Info,
  'layers-2': Layers2,
  lock: Lock,
  maximize: Maximize,
  minimize: Minimize,
  minus: Minus,
  moon: Moon,
  'octagon-x': OctagonX,
  'panel-left': PanelLeft,
  'panel-right': PanelRight,
  pause: Pause,
  pencil: Pencil,
  play: Play,
  plus: Plus,
  redo: Redo2,
  repeat: Repeat,
  reset: RotateCcw,
  turn: Rotate3d,
  spline: Spline,
  search: Search,
  'step-back': StepBack,
  'step-forward': StepForward,
  sun: Sun,
  tag: Tag,
  'sun-moon': SunMoon,
  'triangle-alert': TriangleAlert,
  undo: Undo2,
  'unfold-horizontal': UnfoldHorizontal,
  waypoints: Waypoints,
  x: X,
  'zoom-in': ZoomIn,
  'zoom-out': ZoomOut,
  'previous-keypose': [
    ['path', { d: 'm18 6-6 6 6 6' }],
    ['circle', { cx: 6, cy: 12, r: 2.6, ...disc }],
  ],
  'next-keypose': [
    ['path', { d: 'm6 6 6 6-6 6' }],
    ['circle', { cx: 18, cy: 12, r: 2.6, ...disc }],
  ],
} satisfies Record<string, IconNode>;

export type IconName = keyof typeof shapes;

function symbol(name: string, node: IconNode): SVGSymbolElement {
  const result = document.createElementNS(svgNamespace, 'symbol');
  result.id = `icon-${name}`;
  result.setAttribute('viewBox', '0 0 24 24');
  for (const [tag, attributes] of node) {
    const shape = document.createElementNS(svgNamespace, tag);
    for (const [key, value] of Object.entries(attributes)) shape.setAttribute(key, String(value));
    result.append(shape);
  }
  return result;
}

/** Puts the sheet of symbols on the page; icons show from then on. */
export function installIcons(parent: Element): void {
  const sheet = document.createElementNS(svgNamespace, 'svg');
  sheet.setAttribute('class', 'icon-sheet');
  sheet.setAttribute('aria-hidden', 'true');
  sheet.append(...Object.entries(shapes).map(([name, node]) => symbol(name, node)));
  parent.prepend(sheet);
}

export function icon(name: IconName, size = 16): TemplateResult {
  return html`<svg
    class="icon icon-${name}"
    width=${size}
    height=${size}
    viewBox="0 0 24 24"
    aria-hidden="true"
  >
    <use href="#icon-${name}" />
  </svg>`;
}

/** The mark: a valley with a disc at rest. */
export function mark(): TemplateResult {
  return html`<svg class="mark" width="22" height="22" viewBox="0 0 22 22" aria-hidden="true">
    <path class="mark-valley" d="M2.2 4.2C5.2 4.2 6.2 14.4 11 14.4S16.8 4.2 19.8 4.2" />
    <circle class="mark-disc" cx="11" cy="14.4" r="3.6" />
  </svg>`;
}
