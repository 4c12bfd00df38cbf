/** Pure: lines that rise or stand, by which one time is told from another. */
/** A rising line: its value anywhere, and back. */
export interface Rising {
  /** Where it begins. */
  readonly begin: number;
  /** Where it ends. */
  readonly end: number;
  /** The value at a place; before the first and after the last place theirs. */
  at(place: number): number;
  /** The place of a value; of a value that lasts, the middle. */
  placeOf(value: number): number;
}

/** Knots in; the line through them out. Places and values never fall from knot to knot. */
export class Curve implements Rising {
  constructor(
    private readonly places: ArrayLike<number>,
    private readonly values: ArrayLike<number>,
  ) {}

  get begin(): number {
    return this.places[0] ?? 0;
  }

  get end(): number {
    return this.places[this.places.length - 1] ?? 0;
  }

  at(place: number): number {
    return between(this.places, this.values, place);
  }

  placeOf(value: number): number {
    const { places, values } = this;
    const first = firstFrom(values, (other) => other >= value);
    const end = firstFrom(values, (other) => other > value);
    if (end - first > 1) return (places[first] + places[end - 1]) / 2;
    return between(values, places, value);
  }
}

/** One line after another: the outer's values at those of the inner. */
export class Chained implements Rising {
  constructor(
    private readonly outer: Rising,
    private readonly inner: Rising,
  ) {}

  get begin(): number {
    return this.inner.begin;
  }

  get end(): number {
    return this.inner.end;
  }

  at(place: number): number {
    return this.outer.at(this.inner.at(place));
  }

  placeOf(value: number): number {
    return this.inner.placeOf(this.outer.placeOf(value));
  }
}

function between(from: ArrayLike<number>, to: ArrayLike<number>, at: number): number {
  const next = firstFrom(from, (other) => other >= at);
  if (next === 0) return to[0] ?? 0;
  if (next === from.length) return to[next - 1];
  const width = from[next] - from[next - 1];
  const part = width > 0 ? (at - from[next - 1]) / width : 1;
  return to[next - 1] + (to[next] - to[next - 1]) * part;
}

/** Index of the first number that holds, those before it not holding; the length if none. */
function firstFrom(numbers: ArrayLike<number>, holds: (value: number) => boolean): number {
  let [low, high] = [0, numbers.length];
  while (low < high) {
    const middle = (low + high) >>> 1;
    if (holds(numbers[middle])) high = middle;
    else low = middle + 1;
  }
  return low;
}
