/** Fingers on an axis in; how far two of them spread it out. */

/** The axis grows by a factor; the pixel keeps its moment. */
export interface Spread {
  readonly factor: number;
  readonly about: number;
}

export class Touches {
  private readonly places = new Map<number, number>();

  get count(): number {
    return this.places.size;
  }

  put(id: number, x: number): void {
    this.places.set(id, x);
  }

  lift(id: number): void {
    this.places.delete(id);
  }

  has(id: number): boolean {
    return this.places.has(id);
  }

  /** A finger moves: the other one keeps the moment that it touches. */
  move(id: number, x: number): Spread | null {
    const about = [...this.places].find(([touch]) => touch !== id)?.[1];
    const before = this.places.get(id);
    this.places.set(id, x);
    if (about === undefined || before === undefined || before === about) return null;
    const factor = (x - about) / (before - about);
    return Math.abs(x - about) >= 1 && factor > 0 ? { factor, about } : null;
  }
}
