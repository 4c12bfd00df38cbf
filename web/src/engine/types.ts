/**
 * What crosses between the engine and the app: plain data and typed arrays, owned by JavaScript.
 * Frames count from 0 in the file; times are seconds; positions are in file units and world axes.
 */
import type { ClipFeature, PostureSequence } from './clip-feature';

/** Names of the principal joints and hips, as everywhere in Keypose's output. */
export type Role =
  | 'left_hip'
  | 'left_shoulder'
  | 'left_elbow'
  | 'left_wrist'
  | 'left_finger'
  | 'left_knee'
  | 'left_ankle'
  | 'left_toe'
  | 'right_hip'
  | 'right_shoulder'
  | 'right_elbow'
  | 'right_wrist'
  | 'right_finger'
  | 'right_knee'
  | 'right_ankle'
  | 'right_toe'
  | 'neck'
  | 'head';

export type UpAxis = '+X' | '-X' | '+Y' | '-Y' | '+Z' | '-Z';

export type UnitName = 'm' | 'dm' | 'cmu' | 'inch' | 'cm' | 'mm';

/** Where a value came from: found in the motion, a default, or the person's own. */
export type ValueSource = 'found' | 'default' | 'user';

/** What a person decided about one clip; absent = as found. */
export interface Decisions {
  readonly frameRateHz?: number;
  readonly leadingRestFrames?: number;
  readonly up?: UpAxis;
  readonly unit?: UnitName;
  /** Along the up axis, in file units. */
  readonly groundHeight?: number;
  /** Joints of the file that stand for principal joints, by performer. */
  readonly joints?: readonly JointDecision[];
}

/** A person's word that a joint of the file is this part of a performer's body. */
export interface JointDecision {
  readonly performer: number;
  readonly role: Role | 'pelvis';
  readonly joint: number;
}

/** The parameters of the method; absent = default (METHOD's). */
export interface MethodOptions {
  readonly lowPassHz?: number;
  readonly scaleMaxHz?: number;
  readonly scaleMinHz?: number;
  readonly scaleRatio?: number;
  readonly selection?: 'automatic' | 'literal' | 'even-split';
}

/** Every parameter with its value. */
export type MethodSettings = Required<MethodOptions>;

/** The parts of the body that a keypose is explained by, in the order of their columns. */
export const bodyParts = ['left-arm', 'right-arm', 'left-leg', 'right-leg', 'head'] as const;

export type BodyPart = (typeof bodyParts)[number];

type ArmState = 'raised' | 'stretched' | 'forward' | 'back' | 'crossed' | 'bent';

type LegState = 'high' | 'raised' | 'lifted' | 'bent';

type TrunkState =
  'leaning-forward' | 'leaning-back' | 'leaning-left' | 'leaning-right' | 'lying' | 'upright';

/** What a pose looks like: a part of the body and what it does, in words of the catalogue. */
export type PostureWord =
  | `${'left-arm' | 'right-arm' | 'both-arms'}-${ArmState}`
  | `${'left' | 'right'}-leg-${LegState | 'forward'}`
  | `both-legs-${LegState | 'apart' | 'crossed'}`
  | `trunk-${TrunkState}`;

/** A departure from the plain form of a file; `kind` and `details` fill the catalogue's sentence. */
export interface Note {
  readonly kind: string;
  readonly line: number | null;
  readonly column: number | null;
  readonly frame: number | null;
  readonly details: readonly string[];
}

/** Why a file could not be read or worked on. */
export interface Failure {
  readonly kind: string;
  readonly line: number | null;
  readonly column: number | null;
  readonly details: readonly string[];
}

/** The error every promise of the engine rejects with, except for an AbortError after a cancel. */
export class EngineError extends Error {
  readonly failure: Failure;
  readonly fileName: string;

  constructor(failure: Failure, fileName: string) {
    super(`${fileName}: ${failure.kind} ${failure.details.join(' ')}`);
    this.name = 'EngineError';
    this.failure = failure;
    this.fileName = fileName;
  }
}

export interface Skeleton {
  /** Unique joint labels; an End Site is its parent's label and `/end`. */
  readonly labels: readonly string[];
  /** Parent of each joint, -1 at the root. */
  readonly parents: Int32Array;
  readonly endSites: Uint8Array;
}

export interface BodyJoint {
  readonly role: Role;
  readonly joint: number;
  readonly source: 'name' | 'shape' | 'user' | 'fallback';
}

export interface Body {
  readonly kind: 'human' | 'other';
  readonly pelvis: number;
  /** Body height in file units. */
  readonly height: number;
  /** Hips and the 16 principal joints; empty where the body is not human. */
  readonly joints: readonly BodyJoint[];
}

export interface Anova {
  readonly f: number;
  readonly p: number;
  readonly betweenDegrees: number;
  readonly withinDegrees: number;
}

/** Keyposes and every series between them and the motion, of one performer. */
export interface KeyposeResult {
  /** Motion speed in body heights per second; element n belongs to frame `firstFrame + n`. */
  readonly speed: Float64Array;
  readonly firstFrame: number;
  /** The speed low-passed at 0.5 Hz. */
  readonly trend: Float64Array;
  readonly maximumSpeed: number;
  readonly scalesHz: Float64Array;
  /** Frames of the candidates, ascending. */
  readonly candidates: Int32Array;
  readonly intensities: Float64Array;
  /** Candidate c's trace is [traceOffsets[c], traceOffsets[c + 1]) of the three arrays below. */
  readonly traceOffsets: Int32Array;
  /** Index into `scalesHz`. */
  readonly traceScales: Int32Array;
  readonly traceFrames: Int32Array;
  readonly traceIntensities: Float64Array;
  /** Where each minimum of a trace lies between the frames, in frames of the file. */
  readonly tracePlaces: Float64Array;
  /** Indices into `candidates` from the most to the least intense, of equals the earlier first. */
  readonly byIntensity: Int32Array;
  /** Of each candidate, the index into `scalesHz` of its largest u; -1 without a trace. */
  readonly strongestScales: Int32Array;
  /** Indices into `candidates`, in time order. */
  readonly keyposes: Int32Array;
  /**
   * Keyposes × `bodyParts`: speed of the part at the keypose against its mean within ± 0.5 s, less 1,
   * in percent; NaN where the mean is no speed. Empty where the body is not human.
   */
  readonly bodyPartPercents: Float64Array;
  /** What each keypose looks like, at most two words, the most telling first; empty if not human. */
  readonly postures: readonly (readonly PostureWord[])[];
  readonly clusters: number;
  readonly anova: Anova | null;
  /** Lowest kept over highest dropped intensity; Infinity when nothing of weight was dropped. */
  readonly sureness: number;
  /** (lowest kept + highest dropped) / 2; null without keyposes. */
  readonly cut: number | null;
}

export interface PerformerResult {
  readonly skeleton: Skeleton;
  readonly body: Body;
  readonly up: { readonly axis: UpAxis; readonly source: ValueSource };
  /** Ground height along the up axis, in file units. */
  readonly groundHeight: number;
  /** null: unknown, the grid is in body heights. */
  readonly unit: {
    readonly name: UnitName;
    readonly metres: number;
    readonly source: ValueSource;
  } | null;
  readonly leadingRestFrames: number;
  readonly leadingRestReason: 'none' | 't-pose' | 'blended-t-pose' | 'jump' | 'user';
  /** null with `unanalysed` saying why: too few frames, no motion. */
  readonly keyposes: KeyposeResult | null;
  readonly unanalysed: Failure | null;
  /** Posture-variation feature, squared body heights. */
  readonly feature: Float64Array | null;
  /** What the performer is compared by; null where it is not human or has less than two frames. */
  readonly comparable: ClipFeature | null;
  /** The most unusual keypose (or frame) for the thumbnail. */
  readonly thumbnailFrame: number;
  /** Yaw of a viewer (radians, as in figure/up-frame.ts) who sees the figures' widest side. */
  readonly sideYawRad: number;
  /** Yaw of a viewer whom the pelvis faces in the mean, radians, for the preset "Front". */
  readonly frontYawRad: number;
  /** Joints whose trails are drawn at first: the wrist and the ankle with the longest path; empty if not human. */
  readonly trailJoints: Int32Array;
  readonly notes: readonly Note[];
}

export interface ClipResult {
  readonly frames: number;
  readonly frameTimeS: number;
  readonly frameTimeSource: ValueSource;
  /** Notes of the reading; each performer has its own besides. */
  readonly notes: readonly Note[];
  readonly performers: readonly PerformerResult[];
  /** World positions of the first performer's joints at its thumbnail frame; empty without frames. */
  readonly thumbnailPose: Float32Array;
}

/** What a first, quick reading tells of one clip among many: enough to compare it. */
export interface ClipSurvey {
  readonly id: ClipId;
  /** Why the file could not be read; the rest says nothing then. */
  readonly failure: Failure | null;
  readonly frames: number;
  readonly frameTimeS: number;
  /** null with `incomparable` saying why. */
  readonly feature: ClipFeature | null;
  readonly incomparable: Failure | null;
}

/** One clip of many to survey. */
export interface SurveyItem {
  readonly id: ClipId;
  readonly source: ClipSource;
}

/** Where a clip's bytes are: a File or Blob that stays readable while the clip is open. */
export interface ClipSource {
  /** File name as shown. */
  readonly name: string;
  /** Folder or archive path in front of the name, '' if none. */
  readonly folder: string;
  readonly blob: Blob;
}

export interface Progress {
  readonly stage: 'waiting' | 'reading' | 'analysing';
  /** 0 to 1 within the whole work on this clip. */
  readonly done: number;
}

export interface WorkOptions {
  readonly signal?: AbortSignal;
  readonly onProgress?: (progress: Progress) => void;
}

export interface UnzipOptions extends WorkOptions {
  /** Told of each entry that cannot be unpacked; the others go on. */
  readonly onFailure?: (error: EngineError) => void;
}

export type ClipId = number;

export type ExportKind =
  | 'keyposes-csv'
  | 'keyposes-json'
  | 'candidates-csv'
  | 'candidates-json'
  | 'traces-csv'
  | 'traces-json';

export interface SampleInfo {
  readonly id: string;
  readonly motion: 'slow-dance' | 'tired-dance' | 'walk' | 'run';
  readonly fileName: string;
}

/** The one door to the workers. */
export interface Engine {
  /** Reads and analyses a clip in a worker of its own choosing. */
  open(
    id: ClipId,
    source: ClipSource,
    decisions: Decisions,
    options: MethodOptions,
    work?: WorkOptions,
  ): Promise<ClipResult>;
  /** Analyses an opened clip again, with other decisions or parameters; an older run is cancelled. */
  analyse(
    id: ClipId,
    decisions: Decisions,
    options: MethodOptions,
    work?: WorkOptions,
  ): Promise<ClipResult>;
  /** Reads many clips for what comparing needs, a group at a time; their motions are not kept. */
  survey(
    items: readonly SurveyItem[],
    onSurveyed: (some: readonly ClipSurvey[]) => void,
    work?: WorkOptions,
  ): Promise<void>;
  /** The postures of a performer, frame by frame, for warping. */
  postures(id: ClipId, performer: number, work?: WorkOptions): Promise<PostureSequence>;
  /** World positions of all joints at the frames given: frames × joints × 3, file units. */
  poses(
    id: ClipId,
    performer: number,
    frames: Int32Array,
    work?: WorkOptions,
  ): Promise<Float32Array>;
  /** The same for a run of frames, for playback. */
  poseRange(
    id: ClipId,
    performer: number,
    firstFrame: number,
    count: number,
    work?: WorkOptions,
  ): Promise<Float32Array>;
  /** A file of results, written by the core. */
  exportText(id: ClipId, kind: ExportKind, work?: WorkOptions): Promise<string>;
  /** Entries of a .zip that end in .bvh, unpacked in a worker, one by one. */
  unzip(archive: Blob, onEntry: (source: ClipSource) => void, work?: UnzipOptions): Promise<void>;
  /** The default of every parameter of the method. */
  methodDefaults(): Promise<MethodSettings>;
  samples(): Promise<readonly SampleInfo[]>;
  /** A sample motion as a file, made by the generator in a worker. */
  sample(id: string): Promise<ClipSource>;
  /** Says which clip is on the stage: its motion is never dropped, and its work goes first. */
  keep(id: ClipId | null): void;
  /** Frees a clip everywhere. */
  close(id: ClipId): void;
  destroy(): void;
}
