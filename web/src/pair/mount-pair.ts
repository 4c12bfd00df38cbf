/** The place of the page in; two clips beside each other out. */
import type { Context } from '../app/context';
import { mount } from '../common/mount';

export function mountPair(place: HTMLElement, { language }: Context): void {
  mount(place, () => language.words.value.t('top.page.pair'));
}
