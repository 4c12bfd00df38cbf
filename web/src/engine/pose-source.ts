/**
 * Poses for playback: in goes a clip of the engine, out comes the pose of any frame at once or not
 * yet. Chunks of frames are fetched ahead in the direction of play and kept while memory allows.
 */
import type { ClipId, Engine } from './types';

/** The poses of one performer; world positions in file units. */
export interface PoseSource {
  readonly jointCount: number;
  readonly frames: number;
  /**
   * The pose of a frame, joints × (x, y, z), or null while it is on its way (it has then been asked
   * for). The array belongs to the source: read it, don't keep it, don't write to it.
   */
  read(frame: number): Float32Array | null;
  /** Asks for the frame and for what follows it: 1 forward, -1 backward, 0 neither. */
  prefetch(frame: number, direction: -1 | 0 | 1): void;
  /** Calls back whenever poses have arrived. Returns what ends that. */
  onArrive(callback: () => void): () => void;
  /** Cancels what is on its way and frees the poses. */
  destroy(): void;
}

export interface PoseSourceOptions {
  /** Frames fetched together; default 256. */
  readonly chunkFrames?: number;
  /** Poses kept at most, in bytes; default 64 MiB. */
  readonly maximumBytes?: number;
  /** Chunks fetched ahead; default 2. */
  readonly chunksAhead?: number;
  /** Told when poses cannot be had; the chunk can be asked for again a second later. */
  readonly onError?: (error: unknown) => void;
}

const DEFAULTS = { chunkFrames: 256, maximumBytes: 64 * 2 ** 20, chunksAhead: 2 };

/** Requests under way at once; further ones wait, and of the waiting only the latest counts. */
const MAXIMUM_UNDER_WAY = 4;

/** The performer's poses, fetched from the engine as they are needed. Frame 0 of a clip without frames is its skeleton's rest pose. */
export function createPoseSource(
  engine: Pick<Engine, 'poseRange'>,
  clip: ClipId,
  performer: number,
  shape: { readonly jointCount: number; readonly frames: number },
  options: PoseSourceOptions = {},
): PoseSource {
  const fetch = (first: number, count: number, signal: AbortSignal) =>
    engine.poseRange(clip, performer, first, count, { signal });
  return new ChunkedPoses(fetch, shape.jointCount, Math.max(1, shape.frames), options);
}

type FetchPoses = (first: number, count: number, signal: AbortSignal) => Promise<Float32Array>;

/** How long a chunk that failed is left alone. */
const RETRY_MS = 1000;

/** One view for every frame of the chunk, made on arrival so that reading allocates nothing. */
type Chunk = readonly Float32Array[];

class ChunkedPoses implements PoseSource {
  readonly jointCount: number;
  readonly frames: number;
  private readonly fetch: FetchPoses;
  private readonly chunkFrames: number;
  private readonly chunksAhead: number;
  private readonly maximumChunks: number;
  private readonly onError: (error: unknown) => void;
  /** In the order of last use, the latest last. */
  private readonly chunks = new Map<number, Chunk>();
  private readonly underWay = new Set<number>();
  private readonly listeners = new Set<() => void>();
  private readonly abort = new AbortController();
  private waiting: number | null = null;
  private lastIndex = -1;
  private lastChunk: Chunk | null = null;

  constructor(fetch: FetchPoses, jointCount: number, frames: number, options: PoseSourceOptions) {
    this.fetch = fetch;
    this.jointCount = jointCount;
    this.frames = frames;
    this.chunkFrames = options.chunkFrames ?? DEFAULTS.chunkFrames;
    this.chunksAhead = options.chunksAhead ?? DEFAULTS.chunksAhead;
    this.onError = options.onError ?? (() => undefined);
    const chunkBytes = Math.max(
      1,
      this.chunkFrames * jointCount * 3 * Float32Array.BYTES_PER_ELEMENT,
    );
    const fitting = Math.floor((options.maximumBytes ?? DEFAULTS.maximumBytes) / chunkBytes);
    this.maximumChunks = Math.max(fitting, this.chunksAhead + 2);
  }

  read(frame: number): Float32Array | null {
    const index = this.chunkOf(frame);
    if (index === null) return null;
    const chunk = index === this.lastIndex ? this.lastChunk : this.use(index);
    if (chunk === null) {
      this.request(index);
      return null;
    }
    return chunk[frame - index * this.chunkFrames] ?? null;
  }

  prefetch(frame: number, direction: -1 | 0 | 1): void {
    const index = this.chunkOf(frame);
    if (index === null) return;
    const ahead = direction === 0 ? 0 : this.chunksAhead;
    for (let step = 0; step <= ahead; step += 1) this.request(index + step * direction);
  }

  onArrive(callback: () => void): () => void {
    this.listeners.add(callback);
    return () => this.listeners.delete(callback);
  }

  destroy(): void {
    this.abort.abort();
    this.listeners.clear();
    this.chunks.clear();
    this.lastChunk = null;
    this.lastIndex = -1;
  }

  private chunkOf(frame: number): number | null {
    const inside = Number.isInteger(frame) && frame >= 0 && frame < this.frames;
    return inside ? Math.floor(frame / this.chunkFrames) : null;
  }

  /** The chunk, moved to the latest place in the order of use. */
  private use(index: number): Chunk | null {
    const chunk = this.chunks.get(index);
    if (chunk === undefined) return null;
    this.chunks.delete(index);
    this.chunks.set(index, chunk);
    this.lastIndex = index;
    this.lastChunk = chunk;
    return chunk;
  }

  private request(index: number): void {
    const first = index * this.chunkFrames;
    if (first < 0 || first >= this.frames || this.abort.signal.aborted) return;
    if (this.chunks.has(index) || this.underWay.has(index)) return;
    if (this.underWay.size >= MAXIMUM_UNDER_WAY) {
      this.waiting = index;
      return;
    }
    this.underWay.add(index);
    void this.load(index, first);
  }

  private async load(index: number, first: number): Promise<void> {
    try {
      const count = Math.min(this.chunkFrames, this.frames - first);
      const poses = await this.fetch(first, count, this.abort.signal);
      if (!this.abort.signal.aborted) this.keep(index, this.viewsOf(poses, count));
    } catch (error) {
      if (this.abort.signal.aborted) return;
      this.onError(error);
      // Drawing asks again with every frame: what fails is not to be tried as often.
      await new Promise((resolve) => setTimeout(resolve, RETRY_MS));
    } finally {
      this.underWay.delete(index);
      const next = this.waiting;
      this.waiting = null;
      if (next !== null) this.request(next);
    }
  }

  private viewsOf(poses: Float32Array, count: number): Chunk {
    const width = this.jointCount * 3;
    if (poses.length !== count * width) {
      throw new RangeError(
        `${count} frames of ${width} values expected, ${poses.length} values came`,
      );
    }
    return Array.from({ length: count }, (_, frame) =>
      poses.subarray(frame * width, (frame + 1) * width),
    );
  }

  private keep(index: number, chunk: Chunk): void {
    this.chunks.set(index, chunk);
    for (const oldest of this.chunks.keys()) {
      if (this.chunks.size <= this.maximumChunks) break;
      if (oldest !== this.lastIndex) this.chunks.delete(oldest);
    }
    for (const listener of this.listeners) listener();
  }
}
