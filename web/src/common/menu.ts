/** A button with a menu under it, on the browser's own popover: it closes by Escape and by a press outside. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { icon, type IconName } from './icons';

export interface MenuItem {
  readonly label: string;
  readonly icon?: IconName;
  /** Given for items of which one or some are chosen. */
  readonly checked?: boolean;
  /** A line stands above it. */
  readonly apart?: boolean;
  readonly onChoose: () => void;
}

export interface Menu {
  readonly id: string;
  readonly name: IconName;
  readonly label: string;
  readonly items: readonly MenuItem[];
}

const gapPx = 4;

/** Under the button, its right edge with the button's. */
function place(menu: HTMLElement): void {
  const button = document.querySelector(`[popovertarget="${menu.id}"]`);
  if (!button) return;
  const { right, bottom } = button.getBoundingClientRect();
  menu.style.top = `${bottom + gapPx}px`;
  menu.style.left = `${Math.max(gapPx, right - menu.offsetWidth)}px`;
}

const itemsOf = (menu: HTMLElement): HTMLElement[] => [
  ...menu.querySelectorAll<HTMLElement>('[role^="menuitem"]'),
];

function onToggle(event: Event): void {
  const menu = event.currentTarget as HTMLElement;
  if (!menu.matches(':popover-open')) return;
  place(menu);
  const items = itemsOf(menu);
  const chosen = items.find((item) => item.getAttribute('aria-checked') === 'true');
  (chosen ?? items[0])?.focus();
}

function onKey(event: KeyboardEvent): void {
  const items = itemsOf(event.currentTarget as HTMLElement);
  const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  if (!step) return;
  event.preventDefault();
  const index = items.indexOf(document.activeElement as HTMLElement);
  items.at((index + step) % items.length)?.focus();
}

function menuItem(item: MenuItem): TemplateResult {
  const choose = (event: Event): void => {
    (event.currentTarget as HTMLElement).closest<HTMLElement>('[popover]')?.hidePopover();
    item.onChoose();
  };
  const checkable = item.checked !== undefined;
  return html`<button
    type="button"
    class="menu-item ${item.apart ? 'apart' : ''}"
    role=${checkable ? 'menuitemradio' : 'menuitem'}
    aria-checked=${checkable ? String(item.checked) : nothing}
    @click=${choose}
  >
    <span class="menu-icon"
      >${item.checked ? icon('check', 14) : item.icon ? icon(item.icon, 15) : nothing}</span
    >${item.label}
  </button>`;
}

export function menuButton({ id, name, label, items }: Menu): TemplateResult {
  return html`<button
      type="button"
      class="icon-button small"
      popovertarget=${id}
      aria-haspopup="menu"
      aria-label=${label}
      data-tip=${label}
    >
      ${icon(name, 15)}
    </button>
    <div
      id=${id}
      class="menu"
      popover
      role="menu"
      aria-label=${label}
      @toggle=${onToggle}
      @keydown=${onKey}
    >
      ${items.map(menuItem)}
    </div>`;
}
