/**
 * What the engine and its workers say to each other: plain data, typed arrays and Blobs.
 */
import type { PostureSequence } from './clip-feature';
import type {
  ClipId,
  ClipResult,
  ClipSurvey,
  Decisions,
  ExportKind,
  Failure,
  MethodOptions,
  MethodSettings,
  Progress,
  SampleInfo,
  SurveyItem,
} from './types';

/** One piece of work; the engine counts them up. */
export type JobId = number;

/** Everything a worker needs to begin or begin again with a clip: no call depends on an earlier one. */
export interface ClipRef {
  readonly id: ClipId;
  readonly name: string;
  readonly blob: Blob;
  readonly decisions: Decisions;
  readonly options: MethodOptions;
  /** Whether the file has been read before: unreadable now means changed on disk. */
  readonly readBefore: boolean;
}

/** What memory a worker holds after a job. */
export interface Memory {
  /** Bytes of the worker's WebAssembly memory. */
  readonly wasmBytes: number;
  /** Bytes of the motion of the clip that the job was about; 0 without one. */
  readonly motionBytes: number;
}

/** How a job ended. `trapped`: the WebAssembly module is broken, and the worker with it. */
export type Outcome<T> =
  | { readonly status: 'done'; readonly value: T; readonly memory: Memory }
  | { readonly status: 'failed'; readonly failure: Failure; readonly memory: Memory }
  | { readonly status: 'cancelled'; readonly memory: Memory }
  | { readonly status: 'trapped'; readonly message: string };

/** An entry of an archive that a worker has unpacked. */
export interface UnpackedEntry {
  readonly name: string;
  readonly folder: string;
  readonly blob: Blob;
}

/** The surveys of some clips; the numbers of all features in one array. */
export interface SurveyGroup {
  readonly surveys: readonly (Omit<ClipSurvey, 'feature'> & {
    /** Of the performer to whom the feature belongs; null without one. */
    readonly performer: number | null;
  })[];
  /** Packed, one for each survey that has one. */
  readonly features: Float64Array;
}

/** What a worker says in the middle of a job. */
export interface WorkerListener {
  progress(job: JobId, progress: Progress): void;
  /** Settled once it is taken: an outcome travels another way, and must not overtake it. */
  entry(job: JobId, entry: UnpackedEntry): Promise<void>;
  entryFailure(job: JobId, name: string, failure: Failure): Promise<void>;
}

/** What a worker does. Every method but `cancel`, `close` and `dropMotion` ends with an outcome. */
export interface WorkerApi {
  listen(listener: WorkerListener): void;
  /** Reads the clip if its motion is not there, and analyses it. */
  analyse(job: JobId, clip: ClipRef): Promise<Outcome<ClipResult>>;
  poses(
    job: JobId,
    clip: ClipRef,
    performer: number,
    frames: Int32Array,
  ): Promise<Outcome<Float32Array>>;
  poseRange(
    job: JobId,
    clip: ClipRef,
    performer: number,
    firstFrame: number,
    count: number,
  ): Promise<Outcome<Float32Array>>;
  postures(job: JobId, clip: ClipRef, performer: number): Promise<Outcome<PostureSequence>>;
  /** Reads clips one after another for their features; nothing of them stays. */
  survey(job: JobId, clips: readonly SurveyItem[]): Promise<Outcome<SurveyGroup>>;
  exportText(job: JobId, clip: ClipRef, kind: ExportKind): Promise<Outcome<string>>;
  unzip(job: JobId, archive: Blob): Promise<Outcome<null>>;
  methodDefaults(job: JobId): Promise<Outcome<MethodSettings>>;
  samples(job: JobId): Promise<Outcome<readonly SampleInfo[]>>;
  sample(job: JobId, id: string): Promise<Outcome<UnpackedEntry>>;
  /** Ends a job at its next step. The answer itself says that the worker is alive. */
  cancel(job: JobId): void;
  /** Frees the motion of a clip; it is read again when needed. */
  dropMotion(id: ClipId): void;
  /** Frees everything of a clip. */
  close(id: ClipId): void;
}
