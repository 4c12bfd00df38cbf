/**
 * Questions that follow each other quickly in, as while something is dragged; the answer to the newest
 * out. One is under way at a time; of those that come meanwhile only the last is asked.
 */
import { isAbort } from './failure';

export class LatestAnswer<T> {
  private readonly take: (answer: T) => void;
  private readonly fail: (error: unknown) => void;
  private underWay = false;
  private next: (() => Promise<T>) | null = null;
  private turn = 0;

  constructor(take: (answer: T) => void, fail: (error: unknown) => void) {
    this.take = take;
    this.fail = fail;
  }

  ask(question: () => Promise<T>): void {
    this.next = question;
    if (!this.underWay) void this.goOn();
  }

  /** Whatever was asked is no longer of interest. */
  forget(): void {
    this.next = null;
    this.turn += 1;
  }

  private async goOn(): Promise<void> {
    this.underWay = true;
    while (this.next !== null) {
      const question = this.next;
      const { turn } = this;
      this.next = null;
      try {
        const answer = await question();
        if (this.turn === turn) this.take(answer);
      } catch (error) {
        if (this.turn === turn && !isAbort(error)) this.fail(error);
      }
    }
    this.underWay = false;
  }
}
