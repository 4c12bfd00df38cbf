/**
 * The only file that imports the generated WebAssembly bindings; the rest of the engine sees the
 * types of this one. Positions and numbers come out as copies that JavaScript owns.
 */
import init, {
  ClipHandle,
  Digest,
  initSync,
  sampleBvh,
  methodDefaults,
  sampleCatalogue,
} from './generated/motion_wasm';
import type { ClipFeature } from './clip-feature';
import { refusing } from './core-failure';
import type {
  ClipResult,
  Decisions,
  ExportKind,
  KeyposeResult,
  MethodOptions,
  MethodSettings,
  Note,
  PerformerResult,
  SampleInfo,
} from './types';

/** What is known of a clip before its keyposes. */
export interface Survey extends Pick<ClipResult, 'frames' | 'frameTimeS'> {
  readonly performers: readonly (Pick<
    PerformerResult,
    'body' | 'leadingRestFrames' | 'comparable'
  > & { readonly analysedFrames: number })[];
}

/** The core, ready for work. */
export interface Core {
  /** A clip of its own; whoever makes it frees it, once. */
  newClip(): CoreClip;
  /** The SHA-256 of the bytes pushed. */
  newDigest(): CoreDigest;
  readonly methodDefaults: MethodSettings;
  readonly samples: readonly SampleInfo[];
  /** The bytes of a sample, or null where none has that id. */
  sample(id: string): Uint8Array<ArrayBuffer> | null;
  /** Bytes of the WebAssembly memory; it never shrinks. */
  memoryBytes(): number;
}

export interface CoreDigest {
  push(bytes: Uint8Array): void;
  hexadecimal(): string;
  free(): void;
}

/** One clip in the memory of the core. */
export interface CoreClip {
  /** Begins to read a file of so many bytes; what was read before stays until `endReading`. */
  beginReading(totalBytes: number): void;
  push(bytes: Uint8Array): void;
  endReading(): void;
  /** Makes ready to analyse what was read. */
  beginAnalysis(decisions: Decisions, options: MethodOptions): void;
  /** A few milliseconds of work. Returns the part done; 1 when the result is there. */
  step(): number;
  result(): Omit<ClipResult, 'thumbnailPose'>;
  /** The same as `step` towards the survey and the postures alone; `step` goes on from there. */
  stepSurvey(): number;
  survey(): Survey;
  /** Of analysed frames, counted without the leading rest: frames × 16 joints × 3. */
  postures(performer: number, first: number, count: number): Float64Array<ArrayBuffer>;
  poses(performer: number, frames: Int32Array): Float32Array<ArrayBuffer>;
  poseRange(performer: number, firstFrame: number, count: number): Float32Array<ArrayBuffer>;
  /** The values of a run of rows as the file has them: rows × channels. */
  rows(firstRow: number, count: number): Float64Array<ArrayBuffer>;
  report(kind: ExportKind, fileName: string, sha256: string): string;
  /** Whether poses can be had. */
  hasMotion(): boolean;
  motionBytes(): number;
  /** Frees the motion; results stay. */
  dropMotion(): void;
  free(): void;
}

/** Loads the module: from beside the page, or from the bytes given. */
export async function loadCore(wasm?: Uint8Array<ArrayBuffer>): Promise<Core> {
  const { memory } = wasm === undefined ? await init() : initSync({ module: wasm });
  return {
    newClip: () => new WasmClip(),
    newDigest: () => new Digest(),
    methodDefaults: JSON.parse(methodDefaults()) as MethodSettings,
    samples: JSON.parse(sampleCatalogue()) as SampleInfo[],
    sample: (id) => (sampleBvh(id) as Uint8Array<ArrayBuffer> | undefined) ?? null,
    memoryBytes: () => memory.buffer.byteLength,
  };
}

class WasmClip implements CoreClip {
  private readonly handle = new ClipHandle();

  beginReading(totalBytes: number): void {
    refusing(() => this.handle.beginReading(totalBytes));
  }

  push(bytes: Uint8Array): void {
    refusing(() => this.handle.push(bytes));
  }

  endReading(): void {
    refusing(() => this.handle.endReading());
  }

  beginAnalysis(decisions: Decisions, options: MethodOptions): void {
    refusing(() => this.handle.beginAnalysis(decisions, options));
  }

  step(): number {
    return refusing(() => this.handle.step());
  }

  stepSurvey(): number {
    return refusing(() => this.handle.stepSurvey());
  }

  survey(): Survey {
    const { handle } = this;
    const survey = JSON.parse(refusing(() => handle.survey())) as SurveySummary;
    const performers = survey.performers.map((one, index) => ({
      ...one,
      comparable: comparableOf(handle, index),
    }));
    return { ...survey, performers };
  }

  postures(performer: number, first: number, count: number): Float64Array<ArrayBuffer> {
    const postures = refusing(() => this.handle.postures(performer, first, count));
    return postures as Float64Array<ArrayBuffer>;
  }

  result(): Omit<ClipResult, 'thumbnailPose'> {
    const { handle } = this;
    const summary = JSON.parse(refusing(() => handle.summary())) as ClipSummary;
    const performers = summary.performers.map((one, index) => performerOf(handle, one, index));
    return { ...summary, performers };
  }

  poses(performer: number, frames: Int32Array): Float32Array<ArrayBuffer> {
    return refusing(() => this.handle.poses(performer, frames)) as Float32Array<ArrayBuffer>;
  }

  poseRange(performer: number, firstFrame: number, count: number): Float32Array<ArrayBuffer> {
    const poses = refusing(() => this.handle.poseRange(performer, firstFrame, count));
    return poses as Float32Array<ArrayBuffer>;
  }

  rows(firstRow: number, count: number): Float64Array<ArrayBuffer> {
    return refusing(() => this.handle.rows(firstRow, count)) as Float64Array<ArrayBuffer>;
  }

  report(kind: ExportKind, fileName: string, sha256: string): string {
    return refusing(() => this.handle.report(kind, fileName, sha256));
  }

  hasMotion(): boolean {
    return this.handle.hasMotion();
  }

  motionBytes(): number {
    return this.handle.motionBytes();
  }

  dropMotion(): void {
    this.handle.dropMotion();
  }

  free(): void {
    this.handle.free();
  }
}

/** What the core says of a clip in words and single numbers; the series come as arrays of their own. */
interface ClipSummary extends Omit<ClipResult, 'performers' | 'thumbnailPose'> {
  readonly notes: readonly Note[];
  readonly performers: readonly PerformerSummary[];
}

interface PerformerSummary extends Omit<
  PerformerResult,
  'skeleton' | 'feature' | 'comparable' | 'keyposes' | 'trailJoints'
> {
  readonly labels: readonly string[];
  readonly keyposes: KeyposeSummary | null;
}

interface SurveySummary extends Omit<Survey, 'performers'> {
  readonly performers: readonly Omit<Survey['performers'][number], 'comparable'>[];
}

interface KeyposeSummary extends Pick<
  KeyposeResult,
  'firstFrame' | 'maximumSpeed' | 'clusters' | 'anova' | 'cut' | 'postures'
> {
  /** null: nothing of weight was dropped. */
  readonly sureness: number | null;
}

function performerOf(
  handle: ClipHandle,
  summary: PerformerSummary,
  index: number,
): PerformerResult {
  const { labels, keyposes, ...rest } = summary;
  const feature = handle.feature(index);
  return {
    ...rest,
    skeleton: { labels, parents: handle.parents(index), endSites: handle.endSites(index) },
    keyposes: keyposes === null ? null : keyposesOf(handle, keyposes, index),
    trailJoints: handle.trailJoints(index),
    feature: feature.length === 0 ? null : feature,
    comparable: comparableOf(handle, index),
  };
}

function comparableOf(handle: ClipHandle, performer: number): ClipFeature | null {
  const recorded = handle.recordedFeature(performer);
  if (recorded.length === 0) return null;
  return {
    performer,
    recorded,
    acrossRigs: handle.acrossRigsFeature(performer),
    recordedByJoint: handle.recordedByJoint(performer),
    acrossRigsByJoint: handle.acrossRigsByJoint(performer),
  };
}

function keyposesOf(handle: ClipHandle, summary: KeyposeSummary, index: number): KeyposeResult {
  return {
    ...summary,
    sureness: summary.sureness ?? Number.POSITIVE_INFINITY,
    speed: handle.speed(index),
    trend: handle.trend(index),
    scalesHz: handle.scalesHz(index),
    candidates: handle.candidates(index),
    intensities: handle.intensities(index),
    traceOffsets: handle.traceOffsets(index),
    traceScales: handle.traceScales(index),
    traceFrames: handle.traceFrames(index),
    traceIntensities: handle.traceIntensities(index),
    tracePlaces: handle.tracePlaces(index),
    byIntensity: handle.byIntensity(index),
    strongestScales: handle.strongestScales(index),
    bodyPartPercents: handle.bodyPartPercents(index),
    keyposes: handle.keyposes(index),
  };
}
