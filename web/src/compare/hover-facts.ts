/** The hovered pair in; what the comparison knows of it out, the last one asked for. */
import { signal } from '@preact/signals-core';
import type { ClipPair } from '../app/compare-store';
import type { Comparer, Explanation } from '../engine/comparison-types';

export class HoverFacts {
  readonly known = signal<Explanation | null>(null);
  private asking = false;
  private wanted: ClipPair | null = null;

  constructor(private readonly comparer: Pick<Comparer, 'explain'>) {}

  /** A moving pointer asks for many pairs: only the latest waits. */
  ask(pair: ClipPair): void {
    const known = this.known.peek();
    this.wanted = known?.a === pair.a && known.b === pair.b ? null : pair;
    if (!this.asking) void this.next();
  }

  /** What is known of this pair. */
  value(pair: ClipPair): Explanation | null {
    const known = this.known.value;
    return known?.a === pair.a && known.b === pair.b ? known : null;
  }

  /** Another comparison knows other distances. */
  forget(): void {
    this.known.value = null;
  }

  private async next(): Promise<void> {
    this.asking = true;
    while (this.wanted) {
      const { a, b } = this.wanted;
      this.wanted = null;
      // A clip that has just been taken out has no distance.
      const explanation = await this.comparer.explain(a, b).catch(() => null);
      if (explanation) this.known.value = explanation;
    }
    this.asking = false;
  }
}
