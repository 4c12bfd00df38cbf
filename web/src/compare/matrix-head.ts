/** What stands over the matrix: legend, clips apart, zoom, order. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { MatrixOrder } from '../app/compare-store';
import type { Words } from '../app/i18n/catalogue';
import { keptBeside } from '../common/beside';
import { iconButton } from '../common/buttons';
import { clipName } from '../common/clip-name';
import { icon } from '../common/icons';
import '../styles/segments.css';
import type { Apart } from './apart';
import { legend, type LegendProps } from './legend';

export interface MatrixHeadProps {
  readonly words: Words;
  /** null until something has been compared. */
  readonly legend: LegendProps | null;
  readonly apart: readonly Apart[];
  readonly order: MatrixOrder;
  /** null where everything is as large as it gets. */
  readonly zoom: { readonly zoomed: boolean; readonly by: (factor: number) => void } | null;
  readonly onOrder: (order: MatrixOrder) => void;
  readonly onZoomAll: () => void;
}

const orders = { tree: 'order.tree', label: 'order.by-label', name: 'order.name' } as const;
const zoomStep = 1.5;
const mostListed = 12;

export function matrixHead(props: MatrixHeadProps): TemplateResult {
  return html`${props.legend ? legend(props.legend) : nothing} ${apartButton(props)}
    <span class="grow"></span>
    ${props.legend ? html`${zoomButtons(props)}${orderChoice(props)}` : nothing}`;
}

function zoomButtons({ words: { t }, zoom, onZoomAll }: MatrixHeadProps): unknown {
  if (!zoom) return nothing;
  const button = { small: true };
  return html`<span class="matrix-zoom">
    ${iconButton({ ...button, name: 'zoom-out', label: t('matrix.zoom-out'), disabled: !zoom.zoomed, onPress: () => zoom.by(1 / zoomStep) })}
    ${iconButton({ ...button, name: 'zoom-in', label: t('matrix.zoom-in'), onPress: () => zoom.by(zoomStep) })}
    ${iconButton({ ...button, name: 'focus', label: t('matrix.zoom-all'), disabled: !zoom.zoomed, onPress: onZoomAll })}
  </span>`;
}

function orderChoice({
  words: { t },
  order,
  onOrder,
  legend: shown,
}: MatrixHeadProps): TemplateResult {
  const optimal = shown?.comparison.tree.orderIsOptimal ?? true;
  const onKey = (event: KeyboardEvent): void => {
    const step = { ArrowRight: 1, ArrowLeft: -1, ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const kinds = Object.keys(orders) as MatrixOrder[];
    onOrder(kinds[(kinds.indexOf(order) + step + kinds.length) % kinds.length]);
    const group = event.currentTarget as HTMLElement;
    requestAnimationFrame(() =>
      requestAnimationFrame(() => group.querySelector<HTMLElement>('[tabindex="0"]')?.focus()),
    );
  };
  const one = (kind: MatrixOrder): TemplateResult =>
    html`<button
      type="button"
      role="radio"
      class=${kind === order ? 'on' : ''}
      aria-checked=${kind === order ? 'true' : 'false'}
      tabindex=${kind === order ? 0 : -1}
      data-tip=${kind === 'tree' && !optimal ? t('order.top-only') : nothing}
      @click=${() => onOrder(kind)}
    >
      ${kind === 'tree' ? icon('git-fork', 13) : nothing}${t(orders[kind])}${
        kind === 'tree' && !optimal ? icon('info', 12) : nothing
      }
    </button>`;
  return html`<span
    class="segments"
    role="radiogroup"
    aria-label=${t('order.label')}
    @keydown=${onKey}
    >${(Object.keys(orders) as MatrixOrder[]).map(one)}</span
  >`;
}

const underApart = keptBeside({ opens: 'apart-list', side: 'below', edge: 'left' });

function apartButton({ words: { t }, apart }: MatrixHeadProps): unknown {
  if (apart.length === 0) return nothing;
  const line = ({ clip, reason }: Apart): TemplateResult =>
    html`<li>${clipName(clip.source.name)}<span class="apart-reason">${t(reason)}</span></li>`;
  const rest = apart.length - mostListed;
  return html`<button type="button" class="button ghost apart" popovertarget="apart-list">
      ${icon('info', 14)}${t('compare.apart', apart.length)}
    </button>
    <div id="apart-list" class="menu apart-list" popover @beforetoggle=${underApart}>
      <p>${t('compare.apart.about')}</p>
      <ul>
        ${apart.slice(0, mostListed).map(line)}
        ${rest > 0 ? html`<li>${t('compare.apart.more', rest)}</li>` : nothing}
      </ul>
    </div>`;
}
