/**
 * Which motions stay in memory: in goes what each clip's motion takes and when it is used, out come
 * the clips whose motion is to be dropped.
 */
import type { ClipId } from './types';

/** All motions together, at most: 512 MB. */
export const MOTION_BYTES = 512 * 2 ** 20;

/** The motions held by the workers, in the order of last use. */
export class MotionMemory {
  private readonly bytes = new Map<ClipId, number>();
  private readonly limitBytes: number;
  private kept: ClipId | null = null;

  constructor(limitBytes = MOTION_BYTES) {
    this.limitBytes = limitBytes;
  }

  /** The clip that is never dropped: the one on the stage. */
  keep(id: ClipId | null): void {
    this.kept = id;
  }

  holds(id: ClipId): boolean {
    return this.bytes.has(id);
  }

  isKept(id: ClipId): boolean {
    return this.kept === id;
  }

  /** Notes that a clip was used and holds so many bytes. Returns the clips to drop, oldest first. */
  used(id: ClipId, bytes: number): ClipId[] {
    this.bytes.delete(id);
    if (bytes > 0) this.bytes.set(id, bytes);
    return this.overflow(id);
  }

  forget(id: ClipId): void {
    this.bytes.delete(id);
    if (this.kept === id) this.kept = null;
  }

  total(): number {
    let total = 0;
    for (const bytes of this.bytes.values()) total += bytes;
    return total;
  }

  private overflow(used: ClipId): ClipId[] {
    const dropped: ClipId[] = [];
    let total = this.total();
    for (const [id, bytes] of this.bytes) {
      if (total <= this.limitBytes) break;
      if (id === used || id === this.kept) continue;
      total -= bytes;
      this.bytes.delete(id);
      dropped.push(id);
    }
    return dropped;
  }
}
