/** A row in; a place for what stands in it out. */
import { element } from '../common/element';
import type { RowPlace } from './rows-layout';

export function placeAt(area: HTMLElement, name: string, { top }: RowPlace): HTMLElement {
  const place = element('div', name);
  place.style.top = `${top}px`;
  area.append(place);
  return place;
}
