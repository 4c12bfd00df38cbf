/**
 * Pictures one after the other in; a film as a file out. It goes by the pictures' numbers, never by the
 * screen or a clock: a busy or hidden page makes the same film, only later. One picture is one task, and the
 * next waits until the encoder has room.
 */
import { letMessagesIn } from '../engine/turns';
import type { FilmCodec } from './film-codec';
import type { FilmShape } from './film-shape';
import { WebmWriter } from './webm';

export interface FilmJob {
  readonly shape: FilmShape;
  readonly codec: FilmCodec;
  /** Pictures. */
  readonly count: number;
  /** Draws a picture on a canvas of the film's size. */
  readonly draw: (picture: number) => Promise<HTMLCanvasElement>;
  readonly signal: AbortSignal;
  /** Told how many are done. */
  readonly onProgress: (done: number) => void;
}

/** Pictures that wait for the encoder: enough that it never idles. */
const MOST_WAITING = 4;
/** From one picture that needs no other to the next: how exactly a film can be searched. */
const KEY_EVERY_S = 2;

/** Rejects with the signal's reason when cancelled. */
export async function recordFilm(job: FilmJob): Promise<Blob> {
  const { shape, count, signal, onProgress } = job;
  signal.throwIfAborted();
  const line = new EncodingLine(job);
  try {
    for (let picture = 0; picture < count; picture++) {
      const canvas = await line.unlessStopped(job.draw(picture));
      line.encode(canvas, picture);
      onProgress(picture + 1);
      await letMessagesIn();
      await line.room();
    }
    return await line.finish(count / shape.rate_hz);
  } finally {
    line.close();
    signal.throwIfAborted();
  }
}

class EncodingLine {
  private readonly encoder: VideoEncoder;
  private readonly writer: WebmWriter;
  private readonly stopped: Promise<never>;
  private stop: (reason: unknown) => void = () => undefined;
  private readonly rate_hz: number;
  private readonly keyEvery: number;
  private readonly options: FilmCodec['options'];

  constructor({ shape, codec, signal }: FilmJob) {
    this.rate_hz = shape.rate_hz;
    this.keyEvery = Math.round(KEY_EVERY_S * shape.rate_hz);
    this.options = codec.options;
    this.writer = new WebmWriter({ ...shape, codec: codec.webm });
    this.stopped = new Promise((_, reject) => {
      this.stop = reject;
    });
    // Whoever waits is told; nobody may be waiting.
    this.stopped.catch(() => undefined);
    signal.addEventListener('abort', () => this.stop(signal.reason), { once: true });
    this.encoder = new VideoEncoder({ output: this.onChunk, error: (error) => this.stop(error) });
    this.encoder.configure(codec.config);
  }

  encode(canvas: HTMLCanvasElement, picture: number): void {
    const timestamp = microseconds(picture / this.rate_hz);
    const duration = microseconds((picture + 1) / this.rate_hz) - timestamp;
    const frame = new VideoFrame(canvas, { timestamp, duration });
    try {
      const keyFrame = picture % this.keyEvery === 0;
      this.encoder.encode(frame, { ...this.options, keyFrame });
    } finally {
      frame.close();
    }
  }

  unlessStopped<T>(work: Promise<T>): Promise<T> {
    return Promise.race([this.stopped, work]);
  }

  /** Until the encoder has caught up. */
  async room(): Promise<void> {
    const { encoder } = this;
    while (encoder.encodeQueueSize > MOST_WAITING) {
      const caughtUp = new Promise((resolve) =>
        encoder.addEventListener('dequeue', resolve, { once: true }),
      );
      await this.unlessStopped(caughtUp);
    }
    await this.unlessStopped(Promise.resolve());
  }

  async finish(lengthS: number): Promise<Blob> {
    await this.unlessStopped(this.encoder.flush());
    return this.writer.finish(lengthS);
  }

  close(): void {
    if (this.encoder.state !== 'closed') this.encoder.close();
  }

  private readonly onChunk = (
    chunk: EncodedVideoChunk,
    metadata?: EncodedVideoChunkMetadata,
  ): void => {
    const data = new Uint8Array(chunk.byteLength);
    chunk.copyTo(data);
    const colour = metadata?.decoderConfig?.colorSpace;
    if (colour) this.writer.setColour(colour);
    this.writer.add({ data, timeS: chunk.timestamp / 1e6, key: chunk.type === 'key' });
  };
}

const microseconds = (seconds: number): number => Math.round(seconds * 1e6);
