/** The place of the page in; a set of clips compared out. */
import type { Context } from '../app/context';
import { mount } from '../common/mount';

export function mountCompare(place: HTMLElement, { language }: Context): void {
  mount(place, () => language.words.value.t('top.page.compare'));
}
