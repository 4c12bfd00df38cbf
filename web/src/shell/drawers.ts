/**
 * A side panel that becomes a drawer in; the focus led into it, kept there while it is open and given back
 * to where it was out.
 */
const focusable =
  'a[href], button, input, select, textarea, summary, [tabindex]:not([tabindex="-1"])';

function stopsOf(panel: HTMLElement): HTMLElement[] {
  return [...panel.querySelectorAll<HTMLElement>(focusable)].filter(
    (stop) => stop.tabIndex >= 0 && !stop.matches(':disabled') && stop.checkVisibility(),
  );
}

/** Where the focus goes first: the chosen row or tab. */
function firstStop(panel: HTMLElement): HTMLElement | undefined {
  const stops = stopsOf(panel);
  const chosen = stops.find((stop) =>
    stop.matches('[aria-current="true"], [role="tab"][aria-selected="true"]'),
  );
  return chosen ?? stops[0];
}

/** Tab goes round within the panel. */
function keepInside(panel: HTMLElement, event: KeyboardEvent): void {
  if (event.key !== 'Tab') return;
  const stops = stopsOf(panel);
  const [first, last] = [stops[0], stops.at(-1)];
  const active = document.activeElement;
  const leaves = !panel.contains(active) || active === (event.shiftKey ? first : last);
  if (!leaves) return;
  event.preventDefault();
  (event.shiftKey ? last : first)?.focus();
}

export class Drawers {
  /** What lies behind an open drawer. */
  private readonly behind: readonly HTMLElement[];
  private open: HTMLElement | null = null;
  private opener: HTMLElement | null = null;

  constructor(behind: readonly HTMLElement[]) {
    this.behind = behind;
    document.addEventListener('keydown', (event) => {
      if (this.open && !document.querySelector('dialog[open]')) keepInside(this.open, event);
    });
  }

  /** The panel that is open as a drawer now; null: none. */
  show(panel: HTMLElement | null): void {
    if (panel === this.open) return;
    const before = this.open;
    this.open = panel;
    for (const element of this.behind) element.inert = panel !== null && element !== panel;
    before?.removeAttribute('role');
    before?.removeAttribute('aria-modal');
    if (panel) this.enter(panel, before !== null);
    else this.leave();
  }

  private enter(panel: HTMLElement, fromDrawer: boolean): void {
    const active = document.activeElement;
    if (!fromDrawer) this.opener = active instanceof HTMLElement ? active : null;
    panel.setAttribute('role', 'dialog');
    panel.setAttribute('aria-modal', 'true');
    firstStop(panel)?.focus();
  }

  private leave(): void {
    const { opener } = this;
    this.opener = null;
    if (opener?.isConnected && opener.checkVisibility()) opener.focus();
  }
}
