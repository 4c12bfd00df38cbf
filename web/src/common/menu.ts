/** A button with a menu under it, on the browser's own popover: it closes by Escape and by a press outside. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { keptBeside } from './beside';
import { icon, type IconName } from './icons';

export interface MenuItem {
  readonly label: string;
  /** The language of the label where it is not the page's. */
  readonly lang?: string;
  readonly icon?: IconName;
  /** Given for items of which one or some are chosen. */
  readonly checked?: boolean;
  /** Several can be chosen: the menu stays open. */
  readonly several?: boolean;
  /** A line stands above it. */
  readonly apart?: boolean;
  /** Why it cannot be chosen. */
  readonly barred?: string | undefined;
  readonly onChoose: () => void;
}

export interface Menu {
  readonly id: string;
  readonly name: IconName;
  readonly label: string;
  /** Stands on the button beside the icon: what is chosen. */
  readonly text?: string;
  /** A field that shows what is chosen and ends in an arrow; its menu begins where it does. */
  readonly field?: boolean;
  /** As `aria-keyshortcuts` has them, and as the tip shows them. */
  readonly keys?: string;
  readonly keyText?: string;
  readonly items: readonly MenuItem[];
}

const itemsOf = (menu: HTMLElement): HTMLElement[] => [
  ...menu.querySelectorAll<HTMLElement>('[role^="menuitem"]'),
];

function onToggle(event: Event): void {
  const menu = event.currentTarget as HTMLElement;
  if (!menu.matches(':popover-open')) return;
  const items = itemsOf(menu);
  const chosen = items.find((item) => item.getAttribute('aria-checked') === 'true');
  (chosen ?? items[0])?.focus();
}

function onKey(event: KeyboardEvent): void {
  const items = itemsOf(event.currentTarget as HTMLElement);
  const index = items.indexOf(document.activeElement as HTMLElement);
  const next = { ArrowDown: (index + 1) % items.length, ArrowUp: index - 1, Home: 0, End: -1 }[
    event.key
  ];
  if (next === undefined) return;
  event.preventDefault();
  items.at(next)?.focus();
}

function menuItem(item: MenuItem): TemplateResult {
  const choose = (event: Event): void => {
    const button = event.currentTarget as HTMLElement;
    if (item.barred !== undefined) return;
    if (!item.several) button.closest<HTMLElement>('[popover]')?.hidePopover();
    item.onChoose();
  };
  const checkable = item.checked !== undefined;
  return html`<button
    type="button"
    class="menu-item ${item.apart ? 'apart' : ''}"
    role=${checkable ? (item.several ? 'menuitemcheckbox' : 'menuitemradio') : 'menuitem'}
    lang=${item.lang ?? nothing}
    aria-checked=${checkable ? String(item.checked) : nothing}
    aria-disabled=${item.barred === undefined ? nothing : 'true'}
    @click=${choose}
  >
    <span class="menu-icon"
      >${item.checked ? icon('check', 14) : item.icon ? icon(item.icon, 15) : nothing}</span
    >${
      item.barred === undefined
        ? item.label
        : html`<span class="menu-two"
            ><span>${item.label}</span> <span class="menu-reason">${item.barred}</span></span
          >`
    }
  </button>`;
}

function face({ name, text, field }: Menu): TemplateResult {
  const words = text === undefined ? nothing : html`<span class="menu-text">${text}</span>`;
  if (!field) return html`${icon(name, 15)}${words}`;
  const down = icon('chevron-down', 14);
  return name === 'chevron-down' ? html`${words}${down}` : html`${icon(name, 14)}${words}${down}`;
}

export function menuButton(menu: Menu): TemplateResult {
  const { id, label, text, field, keys, keyText, items } = menu;
  const look =
    text === undefined ? 'icon-button small' : field ? 'button line field-button' : 'button ghost';
  return html`<button
      type="button"
      class=${look}
      popovertarget=${id}
      aria-haspopup="menu"
      aria-label=${text === undefined || text === label ? label : `${label} ${text}`}
      aria-keyshortcuts=${keys ?? nothing}
      data-tip=${text === label ? nothing : label}
      data-key=${keyText ?? nothing}
    >
      ${face(menu)}
    </button>
    <div
      id=${id}
      class="menu"
      popover
      role="menu"
      aria-label=${label}
      @beforetoggle=${keptBeside({ opens: id, side: 'below', edge: field ? 'left' : 'right' })}
      @toggle=${onToggle}
      @keydown=${onKey}
    >
      ${items.map(menuItem)}
    </div>`;
}
