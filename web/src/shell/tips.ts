/** Elements with `data-tip` in; their names with their keys beside them out, after a moment: of pointing, focus, or a finger's press. */
const delayMs = 400;
const gapPx = 6;

function content(owner: HTMLElement): (Node | string)[] {
  const { tip = '', key } = owner.dataset;
  if (!key) return [tip];
  const keys = document.createElement('kbd');
  keys.textContent = key;
  return [tip, keys];
}

/** Below its owner where there is room; above a finger, which would cover it. */
function place(tip: HTMLElement, owner: HTMLElement, touched: boolean): void {
  const box = owner.getBoundingClientRect();
  const left = box.left + box.width / 2 - tip.offsetWidth / 2;
  const below = box.bottom + gapPx;
  const above = box.top - gapPx - tip.offsetHeight;
  const top = (touched && above > 0) || below + tip.offsetHeight > innerHeight ? above : below;
  tip.style.left = `${Math.max(gapPx, Math.min(left, innerWidth - tip.offsetWidth - gapPx))}px`;
  tip.style.top = `${top}px`;
}

export function installTips(parent: HTMLElement): void {
  const tip = document.createElement('div');
  tip.className = 'tip';
  tip.hidden = true;
  tip.setAttribute('aria-hidden', 'true');
  parent.append(tip);
  let timer: ReturnType<typeof setTimeout> | undefined;

  const show = (owner: HTMLElement, touched: boolean): void => {
    if (!owner.isConnected) return;
    tip.replaceChildren(...content(owner));
    tip.hidden = false;
    place(tip, owner, touched);
  };
  const hide = (): void => {
    clearTimeout(timer);
    tip.hidden = true;
  };
  const wait = (event: Event): void => {
    hide();
    const owner =
      event.target instanceof Element ? event.target.closest<HTMLElement>('[data-tip]') : null;
    const reached = event.type !== 'focusin' || owner?.matches(':focus-visible');
    const touched = event instanceof PointerEvent && event.pointerType === 'touch';
    if (owner && reached) timer = setTimeout(() => show(owner, touched), delayMs);
  };
  const press = (event: PointerEvent): void =>
    event.pointerType === 'touch' ? wait(event) : hide();
  for (const type of ['pointerover', 'focusin']) parent.addEventListener(type, wait);
  parent.addEventListener('pointerdown', press, true);
  for (const type of ['pointerup', 'pointerleave', 'focusout', 'keydown', 'scroll'])
    parent.addEventListener(type, hide, true);
}
