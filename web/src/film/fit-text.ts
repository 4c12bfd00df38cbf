/** A text and a width in; as much of it as has room out, with an ellipsis where something is missing. Pure. */

export function fitText(text: string, most: number, widthOf: (text: string) => number): string {
  if (text === '' || widthOf(text) <= most) return text;
  const letters = Array.from(new Intl.Segmenter().segment(text), ({ segment }) => segment);
  let [fits, breaks] = [0, letters.length];
  while (breaks - fits > 1) {
    const middle = (fits + breaks) >> 1;
    if (widthOf(shortened(letters, middle)) <= most) fits = middle;
    else breaks = middle;
  }
  return fits === 0 ? '' : shortened(letters, fits);
}

const shortened = (letters: readonly string[], count: number): string =>
  `${letters.slice(0, count).join('').trimEnd()}…`;
