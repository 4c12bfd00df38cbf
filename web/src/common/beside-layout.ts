/** A button, a panel and the window in; where the panel stands out: pure geometry, in CSS pixels. */

export interface Size {
  readonly width: number;
  readonly height: number;
}

export interface Box {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

export interface Beside {
  /** Of the button, where there is room; else the other one. */
  readonly side: 'above' | 'below';
  /** The edges of button and panel that meet. */
  readonly edge: 'left' | 'right';
}

const GAP = 4;

/** Always in the window; where the window is too small, its beginning is. */
export function beside(
  button: Box,
  panel: Size,
  window: Size,
  { side, edge }: Beside,
): { readonly left: number; readonly top: number } {
  const left = edge === 'left' ? button.left : button.right - panel.width;
  const above = button.top - GAP - panel.height;
  const below = button.bottom + GAP;
  const fits = { above: above >= GAP, below: below + panel.height + GAP <= window.height };
  const other = side === 'above' ? 'below' : 'above';
  const chosen = fits[side] || !fits[other] ? side : other;
  return {
    left: inWindow(left, panel.width, window.width),
    top: inWindow(chosen === 'above' ? above : below, panel.height, window.height),
  };
}

const inWindow = (wanted: number, length: number, room: number): number =>
  Math.max(GAP, Math.min(wanted, room - GAP - length));
