/**
 * What the page and the comparison's worker say to each other: plain data and typed arrays. Features
 * are told once; every request but `tell`, `compare` and `warp` speaks of the comparison made last.
 */
import type * as Compare from './comparison-types';
import type { JobId, Outcome, WorkerListener } from './protocol';
import type { ClipId } from './types';

/** Features that came and clips whose feature went. */
export interface FeatureNews {
  readonly clips: Int32Array;
  readonly names: readonly string[];
  /** Clips × `featureLength`. */
  readonly values: Float64Array;
  readonly gone: Int32Array;
}

/** How the map of a comparison is laid. */
export interface MapPlan {
  readonly keepsPlaces: boolean;
  /** Where clips lay on a map made by another worker; null: this one knows. */
  readonly known: Compare.MapPlaces | null;
}

/** What a comparison's worker does. Every method but `cancel` ends with an outcome. */
export interface ComparisonApi {
  listen(listener: WorkerListener): void;
  cancel(job: JobId): void;
  tell(job: JobId, news: FeatureNews): Promise<Outcome<null>>;
  /** Compares the clips told so far. */
  compare(
    job: JobId,
    settings: Compare.ComparisonSettings,
    plan: MapPlan,
  ): Promise<Outcome<Compare.Comparison>>;
  arrivals(job: JobId): Promise<Outcome<Compare.MapPlaces>>;
  cut(job: JobId, clusters: number): Promise<Outcome<Compare.Cut>>;
  picture(job: JobId, region: Compare.MatrixRegion): Promise<Outcome<Compare.MatrixPicture>>;
  explain(job: JobId, a: ClipId, b: ClipId): Promise<Outcome<Compare.Explanation>>;
  neighbours(
    job: JobId,
    clip: ClipId,
    most: number,
  ): Promise<Outcome<readonly Compare.Neighbour[]>>;
  evaluate(job: JobId, labelled: Compare.LabelledCut): Promise<Outcome<Compare.Evaluation>>;
  exportFile(
    job: JobId,
    kind: Compare.ComparisonExportKind,
    labelled: Compare.LabelledCut,
  ): Promise<Outcome<Blob>>;
  warp(
    job: JobId,
    a: Compare.PostureSequence,
    b: Compare.PostureSequence,
    settings: Compare.WarpSettings,
  ): Promise<Outcome<Compare.Warping>>;
}

const jointValues = 16 * 12;

/** Numbers of one feature when packed: recorded, across rigs, both by joint. */
export const featureLength = 2 * 12 + 2 * jointValues;

/** Writes a feature into its place among packed ones. */
export function packFeature(feature: Compare.ClipFeature, into: Float64Array, index: number): void {
  const at = index * featureLength;
  into.set(feature.recorded, at);
  into.set(feature.acrossRigs, at + 12);
  into.set(feature.recordedByJoint, at + 24);
  into.set(feature.acrossRigsByJoint, at + 24 + jointValues);
}

/** The feature at a place among packed ones; its arrays are parts of the packed one. */
export function unpackFeature(
  packed: Float64Array,
  index: number,
  performer: number,
): Compare.ClipFeature {
  const part = (at: number, length: number): Float64Array =>
    packed.subarray(index * featureLength + at, index * featureLength + at + length);
  return {
    performer,
    recorded: part(0, 12),
    acrossRigs: part(12, 12),
    recordedByJoint: part(24, jointValues),
    acrossRigsByJoint: part(24 + jointValues, jointValues),
  };
}
