/** The hovered pair in; what the comparison knows of it out, the last one asked for. */
import { signal } from '@preact/signals-core';
import type { ClipPair } from '../app/compare-store';
import type { Comparer, Explanation } from '../engine/comparison-types';

const isSame = (one: ClipPair | null, other: ClipPair): boolean =>
  one?.a === other.a && one.b === other.b;

export class HoverFacts {
  readonly known = signal<Explanation | null>(null);
  private asked: ClipPair | null = null;
  private asking = new AbortController();
  private wanted: ClipPair | null = null;

  constructor(private readonly comparer: Pick<Comparer, 'explain'>) {}

  /** A moving pointer asks for many pairs: what was asked of one that it has left is given up. */
  ask(pair: ClipPair): void {
    this.wanted = null;
    if (isSame(this.asked, pair) && !this.asking.signal.aborted) return;
    this.asking.abort();
    if (isSame(this.known.peek(), pair)) return;
    this.wanted = pair;
    if (!this.asked) void this.next();
  }

  /** What is known of this pair. */
  value(pair: ClipPair): Explanation | null {
    const known = this.known.value;
    return isSame(known, pair) ? known : null;
  }

  /** Another comparison knows other distances. */
  forget(): void {
    this.known.value = null;
  }

  private async next(): Promise<void> {
    while (this.wanted) {
      const { a, b } = this.wanted;
      [this.asked, this.wanted, this.asking] = [this.wanted, null, new AbortController()];
      const { signal } = this.asking;
      // A clip that has just been taken out has no distance.
      const explanation = await this.comparer.explain(a, b, { signal }).catch(() => null);
      if (explanation) this.known.value = explanation;
      this.asked = null;
    }
  }
}
