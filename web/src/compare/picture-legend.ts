/** The labels in use and the width of a picture in; a legend in as many lines as it takes, as SVG text, out. */
import type { ComparePalette } from './compare-palette';
import { markTag } from './mark-tag';
import type { Scene } from './scene';
import { tag, textTag } from './svg-text';

const lineHeightPx = 18;
const markPx = 10;
const gapPx = 18;
/** Of one letter at 12 px, and of one that is as wide as high: a little more than either takes. */
const letterPx = { usual: 6.6, full: 12 };
/** Where the writing systems of East Asia begin, whose letters are as wide as high. */
const firstFull = '\u2e80';

export interface PictureLegend {
  readonly heightPx: number;
  /** Its top left corner at (x, y). */
  readonly tags: (palette: ComparePalette, x: number, y: number) => string;
}

interface Entry {
  readonly label: number;
  readonly name: string;
  readonly x: number;
  readonly line: number;
}

const widthOf = (letter: string): number => (letter < firstFull ? letterPx.usual : letterPx.full);

export const textPx = (text: string): number =>
  [...text].reduce((sum, letter) => sum + widthOf(letter), 0);

/** The name, without its middle where it is too wide. */
function fitted(name: string, roomPx: number): string {
  const letters = [...name];
  for (let kept = letters.length; kept > 1; kept -= 1) {
    const [head, tail] = [Math.ceil(kept / 2), Math.floor(kept / 2)];
    const whole = kept === letters.length;
    const text = whole
      ? name
      : `${letters.slice(0, head).join('')}…${letters.slice(letters.length - tail).join('')}`;
    if (textPx(text) <= roomPx) return text;
  }
  return letters[0] ?? '';
}

function entriesOf({ labels, labelOfItem }: Scene, roomPx: number): readonly Entry[] {
  const used = new Set(labelOfItem);
  let [x, line] = [0, 0];
  return labels.flatMap((whole, label) => {
    if (!used.has(label)) return [];
    const name = fitted(whole, roomPx - markPx);
    const widthPx = markPx + textPx(name);
    if (x > 0 && x + widthPx > roomPx) [x, line] = [0, line + 1];
    const entry = { label, name, x, line };
    x += widthPx + gapPx;
    return [entry];
  });
}

export function pictureLegend(scene: Scene, roomPx: number): PictureLegend {
  const entries = entriesOf(scene, roomPx);
  const lines = (entries.at(-1)?.line ?? -1) + 1;
  return {
    heightPx: lines * lineHeightPx,
    tags: (palette, x, y) =>
      entries.map((entry) => entryTags(palette, entry, x + 4, y + lineHeightPx / 2)).join(''),
  };
}

function entryTags(
  palette: ComparePalette,
  { label, name, x, line }: Entry,
  left: number,
  top: number,
): string {
  const y = top + line * lineHeightPx;
  const text = { x: left + x + markPx, y: y + 4, 'font-size': 12, fill: palette.text2 };
  return tag('g', {}, markTag(palette, label, left + x, y, 4) + textTag(name, text));
}
