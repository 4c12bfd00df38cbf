/**
 * Taking turns inside a worker: long work in steps, with a look at messages between them.
 */
import type { JobId } from './protocol';

/** Thrown inside a cancelled job. */
export class Cancelled extends Error {
  constructor() {
    super('cancelled');
    this.name = 'Cancelled';
  }
}

/** Lets every message that waits be delivered; a timer would wait 4 ms, a promise would let none in. */
export function letMessagesIn(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}

/** Work goes on for so long between two looks at messages: steps stay below 50 ms. */
const TURN_MS = 20;

/** The jobs under way and which of them are to end. */
export class Jobs {
  private turnedMs = 0;
  private readonly underWay = new Map<JobId, { cancelled: boolean }>();

  begin(job: JobId): void {
    this.underWay.set(job, { cancelled: false });
  }

  end(job: JobId): void {
    this.underWay.delete(job);
  }

  cancel(job: JobId): void {
    const state = this.underWay.get(job);
    if (state !== undefined) state.cancelled = true;
  }

  /** Whether it is time to look at messages. */
  isTurnOver(): boolean {
    return performance.now() - this.turnedMs >= TURN_MS;
  }

  /** Lets messages in, then throws if the job was cancelled by one. */
  async turn(job: JobId): Promise<void> {
    await letMessagesIn();
    this.turnedMs = performance.now();
    if (this.underWay.get(job)?.cancelled === true) throw new Cancelled();
  }
}
