/** Elements with `data-tip` in; their names with their keys beside them out, after a moment. */
const delayMs = 400;
const gapPx = 6;

function content(owner: HTMLElement): (Node | string)[] {
  const { tip = '', key } = owner.dataset;
  if (!key) return [tip];
  const keys = document.createElement('kbd');
  keys.textContent = key;
  return [tip, keys];
}

function place(tip: HTMLElement, owner: HTMLElement): void {
  const box = owner.getBoundingClientRect();
  const left = box.left + box.width / 2 - tip.offsetWidth / 2;
  const below = box.bottom + gapPx;
  const top = below + tip.offsetHeight > innerHeight ? box.top - gapPx - tip.offsetHeight : below;
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

  const show = (owner: HTMLElement): void => {
    if (!owner.isConnected) return;
    tip.replaceChildren(...content(owner));
    tip.hidden = false;
    place(tip, owner);
  };
  const hide = (): void => {
    clearTimeout(timer);
    tip.hidden = true;
  };
  const wait = (event: Event): void => {
    hide();
    const owner =
      event.target instanceof Element ? event.target.closest<HTMLElement>('[data-tip]') : null;
    const reached = event.type === 'pointerover' || owner?.matches(':focus-visible');
    if (owner && reached) timer = setTimeout(() => show(owner), delayMs);
  };
  for (const type of ['pointerover', 'focusin']) parent.addEventListener(type, wait);
  for (const type of ['pointerdown', 'pointerleave', 'focusout', 'keydown', 'scroll'])
    parent.addEventListener(type, hide, true);
}
