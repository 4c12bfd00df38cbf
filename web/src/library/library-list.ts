/**
 * Presses and keys on the rows of the library in; clips opened, ticked, removed, groups folded out. The
 * keys go from row to row as they stand: a clip opens when it is reached, a head only takes the focus.
 */
import type { Context } from '../app/context';
import type { ClipId } from '../engine/types';
import { clipsBetween, placeOfClip, placeOfGroup, type LibraryLayout } from './entries';
import { scrollToSpan } from './row-window';

/** Control, or Command on a Mac. */
const isAdding = (event: KeyboardEvent | MouseEvent): boolean => event.ctrlKey || event.metaKey;

/** Over the first row and under the last. */
const paddingPx = 4;

export class LibraryList {
  private readonly context: Context;
  private readonly body: HTMLElement;
  private readonly layout: () => LibraryLayout;
  /** Where a range of ticks begins. */
  private anchor: ClipId | null = null;

  constructor(context: Context, body: HTMLElement, layout: () => LibraryLayout) {
    this.context = context;
    this.body = body;
    this.layout = layout;
  }

  press(id: ClipId, event: MouseEvent): void {
    if (event.shiftKey) return this.tickThrough(id);
    if (isAdding(event)) return this.toggle(id);
    this.anchor = id;
    this.context.actions.openClip(id);
    this.context.panels.closeDrawer();
  }

  key(event: KeyboardEvent): void {
    const row = (event.target as HTMLElement)
      .closest('.clip, .group')
      ?.querySelector<HTMLElement>('[data-clip], [data-group]');
    if (!row || event.defaultPrevented || event.altKey) return;
    if (this.onRow(event, this.placeOf(row)) || this.onAll(event)) event.preventDefault();
  }

  /** In view with the least movement; the whole begins with its head. */
  reveal(place: number): void {
    const { tops } = this.layout();
    const list = this.list;
    if (!list || place < 0) return;
    const height = tops[place + 1] - tops[place] + 2 * paddingPx;
    list.scrollTop = scrollToSpan(tops[place], height, list.scrollTop, list.clientHeight);
  }

  focus(selector: string): void {
    // The row is drawn with the next frame.
    requestAnimationFrame(() =>
      requestAnimationFrame(() =>
        this.body.querySelector<HTMLElement>(selector)?.focus({ preventScroll: true }),
      ),
    );
  }

  get list(): HTMLElement | null {
    return this.body.querySelector<HTMLElement>('.library-list');
  }

  remove(id: ClipId): void {
    const { ticked } = this.context.store;
    this.context.actions.remove(...(ticked.peek().has(id) ? ticked.peek() : [id]));
  }

  private onRow(event: KeyboardEvent, place: number): boolean {
    const entry = this.layout().entries[place];
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step !== undefined) {
      if (!isAdding(event)) this.goTo(place + step, event.shiftKey);
      return true;
    }
    if (entry?.kind !== 'clip') return false;
    if (event.key === 'Delete') this.remove(entry.clip.id);
    else if (event.key === ' ' && isAdding(event)) this.toggle(entry.clip.id);
    else return false;
    return true;
  }

  private onAll(event: KeyboardEvent): boolean {
    const { ticked, shown } = this.context.store;
    if (event.key.toLowerCase() === 'a' && isAdding(event))
      ticked.value = new Set(shown.peek().map(({ id }) => id));
    else if (event.key === 'Escape' && ticked.peek().size > 0) ticked.value = new Set();
    else return false;
    return true;
  }

  private goTo(place: number, ticking: boolean): void {
    const entry = this.layout().entries[place];
    if (!entry) return;
    this.reveal(place);
    if (entry.kind === 'group')
      return this.focus(`[data-group="${CSS.escape(entry.label ?? '')}"]`);
    const { id } = entry.clip;
    if (ticking) this.tickThrough(id);
    else this.anchor = id;
    this.context.actions.openClip(id);
    this.focus(`[data-clip="${id}"]`);
  }

  private toggle(id: ClipId): void {
    const { ticked, openId } = this.context.store;
    const before = ticked.peek();
    // As in a list of files, what is open counts as the first of those chosen together.
    const open = before.size === 0 && openId.peek() !== null ? [openId.peek()!] : [];
    const next = new Set([...before, ...open]);
    if (before.has(id)) next.delete(id);
    else next.add(id);
    ticked.value = next;
    this.anchor = id;
  }

  private tickThrough(id: ClipId): void {
    const { ticked, openId } = this.context.store;
    this.anchor ??= openId.peek();
    const from = placeOfClip(this.layout(), this.anchor);
    const to = placeOfClip(this.layout(), id);
    ticked.value = new Set(clipsBetween(this.layout(), from < 0 ? to : from, to));
  }

  private placeOf({ dataset }: HTMLElement): number {
    if (dataset['clip'] !== undefined) return placeOfClip(this.layout(), Number(dataset['clip']));
    return placeOfGroup(this.layout(), dataset['group'] || null);
  }
}
