/** What is compared in; how many clips and pairs it is out, in the middle of the top bar. */
import { html, nothing } from 'lit-html';
import type { Context } from '../app/context';
import { element } from '../common/element';
import { mount } from '../common/mount';

export function mountTopCounts(bar: HTMLElement, { store, language }: Context): void {
  const place = element('p', 'top-counts');
  bar.append(place);
  mount(place, () => {
    const { page, comparison } = store.compare;
    const compared = page.value === 'compare' ? comparison.value : null;
    place.hidden = compared === null;
    if (!compared) return nothing;
    const { t } = language.words.value;
    return html`<strong>${t('library.count', compared.clips.length)}</strong>
      ${t('compare.pairs', compared.pairs)}`;
  });
}
