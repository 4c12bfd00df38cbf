/** The selection and the library in; the menus of A and B, and of the clips that come to them, out. */
import { signal, type Signal } from '@preact/signals-core';
import { html, nothing, type TemplateResult } from 'lit-html';
import { mostTogether } from '../app/compare-actions';
import type { Context } from '../app/context';
import type { Words } from '../app/i18n/catalogue';
import { iconButton } from '../common/buttons';
import { clipName } from '../common/clip-name';
import { element } from '../common/element';
import { icon } from '../common/icons';
import { mount } from '../common/mount';
import type { ClipId, ClipResult } from '../engine/types';
import { clipList, type ListedClip } from './clip-list';
import { shortName } from './pair-clips';
import { who } from './who';

/** Fills the middle of the top bar while the pair page is shown. */
export function mountClipChoice(place: HTMLElement, context: Context): void {
  const choice = element('div', 'pair-choice');
  choice.setAttribute('role', 'group');
  place.append(choice);
  const lists: Lists = { filter: signal(''), open: signal(null) };
  mount(choice, () => {
    const shown = context.store.compare.page.value === 'pair';
    choice.hidden = !shown;
    return shown ? clipChoice(context, lists) : nothing;
  });
}

/** What the lists share: one is open at a time, and only then it has rows. */
interface Lists {
  readonly filter: Signal<string>;
  readonly open: Signal<string | null>;
}

function clipChoice(context: Context, lists: Lists): TemplateResult {
  const { store, compareActions, actions, language } = context;
  const words = language.words.value;
  const { otherId, alsoIds } = store.compare;
  const [a, b, also] = [store.openId.value, otherId.value, alsoIds.value];
  const menu = (place: 0 | 1, id: ClipId | null, onChoose: (id: ClipId) => void): TemplateResult =>
    clipMenu(context, lists, {
      id: `pair-clip-${'ab'[place]}`,
      label: words.t('pair.choose', 'AB'[place]),
      button: html`${who('AB'[place], place)}<span class="pair-clip-name"
          >${nameOf(context, id) ?? words.t('pair.choose.none')}</span
        >${icon('chevron-down', 14)}`,
      chosen: id === null ? [] : [id],
      onChoose,
    });
  const swap = (): void => {
    if (a !== null && b !== null) compareActions.selectPair(b, a);
  };
  return html`
    ${menu(0, a, (id) => (id === b ? swap() : actions.openClip(id)))}
    ${iconButton({ name: 'arrow-up-down', label: words.t('pair.swap'), small: true, disabled: b === null, onPress: swap })}
    ${menu(1, b, (id) => (id === a ? swap() : compareActions.selectOther(id)))}
    ${clipMenu(context, lists, {
      id: 'pair-clip-more',
      label: words.t('pair.add'),
      button: html`${icon('plus', 15)}${also.length > 0 ? also.length : nothing}`,
      chosen: [a, b, ...also].filter((id) => id !== null),
      several: true,
      onChoose: (id) => toggle(context, id),
    })}
  `;
}

/** A third clip is only to be seen on the one stage. */
function toggle({ store, compareActions }: Context, id: ClipId): void {
  const { otherId, alsoIds, superposed } = store.compare;
  const selected = [store.openId.peek(), otherId.peek(), ...alsoIds.peek()];
  if (selected.includes(id)) compareActions.removeFromPair(id);
  else compareActions.addToPair(id);
  if (alsoIds.peek().length > 0) superposed.value = true;
}

interface ClipMenu {
  readonly id: string;
  readonly label: string;
  readonly button: TemplateResult;
  readonly chosen: readonly ClipId[];
  readonly several?: boolean;
  readonly onChoose: (id: ClipId) => void;
}

function clipMenu(context: Context, { filter, open }: Lists, menu: ClipMenu): TemplateResult {
  const words = context.language.words.value;
  const { id, label, button, chosen } = menu;
  const full = menu.several === true && chosen.length >= mostTogether;
  return html`<button
      type="button"
      class="pair-clip"
      popovertarget=${id}
      aria-haspopup="dialog"
      aria-label=${menu.several ? label : nothing}
      data-tip=${label}
    >
      ${button}
    </button>
    ${clipList({
      id,
      label,
      words,
      clips: open.value === id ? listed(context, words, chosen) : null,
      several: menu.several ?? false,
      notice: full ? words.t('pair.add.full', mostTogether) : '',
      filter: filter.value,
      onFilter: (text) => {
        filter.value = text;
      },
      onOpen: (isOpen) => {
        if (isOpen) open.value = id;
        else if (open.peek() === id) open.value = null;
      },
      onChoose: menu.onChoose,
    })}`;
}

function listed({ store }: Context, words: Words, chosen: readonly ClipId[]): ListedClip[] {
  const places = [store.openId.value, store.compare.otherId.value, ...store.compare.alsoIds.value];
  return store.present.value
    .filter(({ status }) => status !== 'failed')
    .map(({ id, source, result }) => ({
      id,
      name: shortName(source.name),
      qualifier: store.qualifiers.value.get(id) ?? '',
      about: lengthText(words, result),
      place: places.includes(id) ? places.indexOf(id) : null,
      chosen: chosen.includes(id),
    }));
}

function lengthText({ t, format }: Words, result: ClipResult | null): string {
  if (!result) return '';
  return t('unit.seconds', format.decimal((result.frames - 1) * result.frameTimeS, 2));
}

function nameOf({ store }: Context, id: ClipId | null): TemplateResult | null {
  const clip = id === null ? undefined : store.clips.value[id];
  if (!clip || clip.removed) return null;
  return clipName(shortName(clip.source.name), store.qualifiers.value.get(clip.id));
}
