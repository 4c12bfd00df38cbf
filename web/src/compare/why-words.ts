/**
 * Why two clips differ in; the plain sentences of it out, with marks where names, symbols and figures
 * stand out. What is said is decided by the comparison; here it is put into words.
 */
import type { Words } from '../app/i18n/catalogue';
import { markFor } from '../common/marked-text';
import type { DistanceSentence, Explanation } from '../engine/comparison-types';
import type { BodyPart } from '../engine/types';

/** The components in their order: σxx … σzx. */
export const components = ['xx', 'yy', 'zz', 'xy', 'yz', 'zx'] as const;
export type Component = (typeof components)[number];

export type Mark =
  | { readonly kind: 'clip'; readonly which: 'a' | 'b' }
  | { readonly kind: 'symbol'; readonly component: Component }
  | { readonly kind: 'strong'; readonly text: string };

export interface MarkedSentence {
  /** With `markFor(index)` where a mark stands. */
  readonly text: string;
  readonly marks: readonly Mark[];
}

type Limbs = 'arms' | 'legs';
type Carrier = BodyPart | Limbs;

const pairs = [
  ['arms', 'left-arm', 'right-arm'],
  ['legs', 'left-leg', 'right-leg'],
] as const;

/** A pair of limbs counts as one where together they are worth naming. */
const namedShare = 0.3;

/** The parts that are worth naming, the largest first. */
export function carriers({
  sentence,
  partShares,
}: Pick<Explanation, 'sentence' | 'partShares'>): (readonly [Carrier, number])[] {
  if (sentence.kind === 'same') return [];
  const named = (part: BodyPart): boolean => sentence.parts.includes(part);
  const single = (part: BodyPart): [Carrier, number][] =>
    named(part) ? [[part, partShares[part]]] : [];
  const limbs = pairs.flatMap(([both, left, right]): [Carrier, number][] => {
    const sum = partShares[left] + partShares[right];
    const together = named(left) === named(right) && sum > namedShare;
    return together ? [[both, sum]] : [...single(left), ...single(right)];
  });
  return [...limbs, ...single('head')].sort(([, a], [, b]) => b - a);
}

class Writer {
  private readonly marks: Mark[] = [];
  private readonly words: Words;

  constructor(words: Words) {
    this.words = words;
  }

  mark(mark: Mark): string {
    this.marks.push(mark);
    return markFor(this.marks.length - 1);
  }

  percent(share: number): string {
    const { t, format } = this.words;
    const text = t('unit.percent', format.integer(share * 100)).replace(' ', '\u00a0');
    return this.mark({ kind: 'strong', text });
  }

  strong(text: string): string {
    return this.mark({ kind: 'strong', text });
  }

  finish(sentences: readonly string[]): MarkedSentence {
    const gap = this.words.language === 'ja' ? '' : ' ';
    return { text: sentences.filter(Boolean).join(gap), marks: this.marks };
  }
}

function componentSentence(
  { t }: Words,
  sentence: Extract<DistanceSentence, { kind: 'component' }>,
  write: Writer,
): string {
  const component = components[sentence.component] ?? 'xx';
  const larger = write.mark({ kind: 'clip', which: sentence.larger });
  const symbol = write.mark({ kind: 'symbol', component });
  const share = write.percent(sentence.share);
  if (sentence.of === 'deviation') {
    const what = write.strong(t(`distance.changes.${component}`));
    return t('distance.differs.deviation', what, symbol, share, larger);
  }
  if (component === 'xx' || component === 'yy' || component === 'zz')
    return t(`distance.further.${component}`, larger, symbol, share);
  const what = write.strong(t(`distance.component.${component}`));
  return t('distance.differs.mean', what, t(`distance.goes.${component}`), symbol, share);
}

function carriedSentence(words: Words, explanation: Explanation, write: Writer): string {
  const { t } = words;
  const named = carriers(explanation).map(([part, share], index) =>
    t(
      index === 0 ? `distance.carried.${part}` : `distance.carried.also.${part}`,
      write.percent(share),
    ),
  );
  return named.length > 0 ? named.join('') + t('distance.carried.end') : '';
}

export function whyWords(words: Words, explanation: Explanation): MarkedSentence {
  const write = new Writer(words);
  const { sentence, mirrored } = explanation;
  const mirror = mirrored
    ? words.t('distance.mirrored', write.mark({ kind: 'clip', which: 'b' }))
    : '';
  if (sentence.kind === 'same') return write.finish([words.t('distance.same'), mirror]);
  const first =
    sentence.kind === 'everything'
      ? words.t('distance.everything')
      : componentSentence(words, sentence, write);
  return write.finish([first, carriedSentence(words, explanation, write), mirror]);
}
