/**
 * A series in; the smallest and largest value of any run of it out, quickly: what an hour of motion is
 * drawn from. The cache of blocks is built in steps, so that no step blocks the page.
 */

/** Values in one block: short runs are read value by value, long ones block by block. */
const BLOCK = 64;

export class Extremes {
  private readonly least: Float64Array;
  private readonly most: Float64Array;
  private built = 0;
  /** Of the last run asked for: written here, so that drawing makes no garbage. */
  minimum = 0;
  maximum = 0;

  constructor(readonly values: Float64Array) {
    const blocks = Math.floor(values.length / BLOCK);
    this.least = new Float64Array(blocks);
    this.most = new Float64Array(blocks);
  }

  get isBuilt(): boolean {
    return this.built === this.least.length;
  }

  /** Builds up to so many more blocks. */
  build(blocks: number): void {
    const end = Math.min(this.least.length, this.built + blocks);
    for (; this.built < end; this.built++) {
      this.start();
      this.takeValues(this.built * BLOCK, (this.built + 1) * BLOCK);
      this.least[this.built] = this.minimum;
      this.most[this.built] = this.maximum;
    }
  }

  /** Starts a run without a value. */
  start(): void {
    this.minimum = Infinity;
    this.maximum = -Infinity;
  }

  takeValue(value: number): void {
    if (value < this.minimum) this.minimum = value;
    if (value > this.maximum) this.maximum = value;
  }

  /** Takes the values from index `from` up to, but without, `to` into the run. */
  take(from: number, to: number): void {
    const first = Math.ceil(from / BLOCK);
    const end = Math.min(this.built, Math.floor(to / BLOCK));
    if (first >= end) return this.takeValues(from, to);
    this.takeValues(from, first * BLOCK);
    for (let block = first; block < end; block++) {
      if (this.least[block] < this.minimum) this.minimum = this.least[block];
      if (this.most[block] > this.maximum) this.maximum = this.most[block];
    }
    this.takeValues(end * BLOCK, to);
  }

  private takeValues(from: number, to: number): void {
    for (let index = from; index < to; index++) this.takeValue(this.values[index]);
  }
}
