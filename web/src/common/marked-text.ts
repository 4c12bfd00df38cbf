/** A sentence of the catalogue with templates in its places: marks in as arguments, the whole out. */
import type { TemplateResult } from 'lit-html';

/** Signs of the private use area, which no catalogue holds. */
const firstMark = 0xe000;

/** Stands for the template of that index. */
export const markFor = (index: number): string => String.fromCharCode(firstMark + index);

export function markedText(text: string, marks: readonly TemplateResult[]): unknown[] {
  return text
    .split(/([\ue000-\ue0ff])/)
    .map((piece) => marks[piece.charCodeAt(0) - firstMark] ?? piece);
}
