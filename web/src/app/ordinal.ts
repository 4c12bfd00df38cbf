/** A place in a row and a language in; "1st", "2番目" out. */
import type { Words } from './i18n/catalogue';

const english = new Intl.PluralRules('en', { type: 'ordinal' });
const endings: Readonly<Partial<Record<Intl.LDMLPluralRule, string>>> = {
  one: 'st',
  two: 'nd',
  few: 'rd',
};

export function ordinal({ language, format }: Words, place: number): string {
  const number = format.integer(place);
  return language === 'ja'
    ? `${number} 番目`
    : `${number}${endings[english.select(place)] ?? 'th'}`;
}
