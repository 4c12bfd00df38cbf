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

/** The jobs under way and which of them are to end. */
export class Jobs {
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

  /** Lets messages in, then throws if the job was cancelled by one. */
  async turn(job: JobId): Promise<void> {
    await letMessagesIn();
    if (this.underWay.get(job)?.cancelled === true) throw new Cancelled();
  }
}
