/**
 * What crosses between the comparison and the app: plain data and typed arrays. An *item* is a clip
 * that can be compared; items count from 0 in the order in which their clips arrived.
 */
import type { ClipFeature } from './clip-feature';
import type { BodyPart, ClipId, WorkOptions } from './types';

export type { ClipFeature, PostureSequence } from './clip-feature';

/** Every distance there is; a new one is a line here, in the core and in the catalogue. */
export const measures = ['posture-variation'] as const;
export type Measure = (typeof measures)[number];

export interface DistanceSettings {
  readonly measure: Measure;
  /** The smaller of the distances to the other clip and to its mirror image; group average only. */
  readonly mirrorAware: boolean;
  /** On bodies of standard lengths. */
  readonly acrossRigs: boolean;
}

export type Linkage = 'ward' | 'average';

export interface ComparisonSettings {
  readonly distance: DistanceSettings;
  readonly linkage: Linkage;
}

/** The tree of the items in SciPy's labelling: merge m makes cluster `items + m`. */
export interface Dendrogram {
  readonly left: Int32Array;
  readonly right: Int32Array;
  readonly heights: Float64Array;
  readonly sizes: Int32Array;
  /** Items from left to right. */
  readonly leaves: Int32Array;
  /** False above 1 000 leaves, where only the top of the tree is ordered optimally. */
  readonly orderIsOptimal: boolean;
}

/** One distance between all items. */
export interface Comparison {
  readonly settings: ComparisonSettings;
  /** The clip of each item. */
  readonly clips: Int32Array;
  readonly pairs: number;
  readonly tree: Dendrogram;
  /** Clusters by BIC (Ward) or Mojena's rule (group average). */
  readonly automaticClusters: number;
  /** Distance at which the colour legend ends: the 98.5th percentile. */
  readonly legendMaximum: number;
  readonly maximum: number;
  /** The item nearest to each item, of equals the earlier; and how far it is. */
  readonly nearest: Int32Array;
  readonly nearestDistances: Float64Array;
  /** items × 2. */
  readonly map: Float64Array;
  /** Part of the spread that the map shows, 0 to 1. */
  readonly spread: number;
}

/** Clips on the map. */
export interface MapPlaces {
  readonly clips: Int32Array;
  /** clips × 2. */
  readonly places: Float64Array;
}

/** The partition at a cut; clusters count from 0 in the order of the tree. */
export interface Cut {
  readonly clusters: number;
  readonly clusterOfItem: Int32Array;
  /** Height between the last merge below the cut and the first above it. */
  readonly height: number;
}

/** A part of the matrix as a picture: mean distances, row by row. */
export interface MatrixPicture {
  readonly rows: number;
  readonly columns: number;
  readonly values: Float32Array;
}

export interface MatrixRegion {
  /** Items from top to bottom and from left to right. */
  readonly order: Int32Array;
  readonly firstRow: number;
  readonly rowCount: number;
  readonly firstColumn: number;
  readonly columnCount: number;
  /** At most so many rows and columns of the picture; each is the mean of many cells if need be. */
  readonly most: number;
}

export interface Neighbour {
  readonly clip: ClipId;
  readonly distance: number;
  readonly mirrored: boolean;
}

/** Why two clips differ (all for the distance of the comparison). */
export interface Explanation {
  readonly a: ClipId;
  readonly b: ClipId;
  readonly distance: number;
  /** The mirror image of b was nearer. */
  readonly mirrored: boolean;
  /** Place among all pairs from 1, the most alike first; ties take the best place. */
  readonly rank: number;
  /** Place of b among the neighbours of a, from 1. */
  readonly rankFromA: number;
  readonly rankFromB: number;
  /** 12 shares of the squared distance. */
  readonly shares: Float64Array;
  /** Shares of `bodyParts`. */
  readonly partShares: Readonly<Record<BodyPart, number>>;
  readonly sentence: DistanceSentence;
}

/** What the plain sentence says; the catalogue words it. */
export type DistanceSentence =
  | { readonly kind: 'same' }
  | { readonly kind: 'everything'; readonly parts: readonly BodyPart[] }
  | {
      readonly kind: 'component';
      /** 0 … 5: σxx … σzx. */
      readonly component: number;
      /** Whether its mean or its deviation differs more. */
      readonly of: 'mean' | 'deviation';
      /** Mean and deviation together, 0 to 1. */
      readonly share: number;
      /** Whose value is larger. */
      readonly larger: 'a' | 'b';
      /** Parts above 30 %, the largest first. */
      readonly parts: readonly BodyPart[];
    };

export type ConfusionField = readonly [own: number, nearest: number, count: number];

/** How well the distance tells the labels apart; unlabelled items are left out. */
export interface Evaluation {
  /** Labels in order of their first item. */
  readonly labels: readonly string[];
  readonly labelled: number;
  readonly correct: number;
  readonly accuracy: number;
  readonly bestReachable: number;
  /** Fields of labels × labels that are not 0: own label, label of the nearest, how many. */
  readonly confusion: readonly ConfusionField[];
  readonly errors: readonly { readonly clip: ClipId; readonly nearest: ClipId }[];
  /** Labels with one clip: it can never be right. */
  readonly single: readonly string[];
  readonly recall: number;
  readonly precision: number;
  readonly f: number;
}

/** How two motions run along each other. */
export interface Warping {
  /** In body heights. */
  readonly distance: number;
  /** Frames of the files, step by step. */
  readonly pathA: Int32Array;
  readonly pathB: Int32Array;
  /** Per step: b/(N_B − 1) − a/(N_A − 1); above 0 A is ahead. */
  readonly ahead: Float64Array;
  /** Steps × `bodyParts`: mean joint distance in body heights. */
  readonly partDistances: Float32Array;
  /** The 98.5th percentile of `partDistances`. */
  readonly fullColour: number;
}

export interface WarpSettings {
  /** The most frames that the path may leave the diagonal; null: no band. */
  readonly band: number | null;
  /** Left and right of b swapped. */
  readonly mirrorB: boolean;
}

export type ComparisonExportKind =
  | 'features-csv'
  | 'features-npy'
  | 'matrix-csv'
  | 'matrix-npy'
  | 'tree-newick'
  | 'evaluation-csv'
  | 'evaluation-json';

export interface LabelledCut {
  readonly clusters: number;
  /** Label of each item; null: unlabelled. */
  readonly labels: readonly (string | null)[];
}

export interface CompareOptions extends WorkOptions {
  /** Clips stay where they lie on the map; those that came since have the place that Gower's formula
   * gives them. Another distance lays all out anew. */
  readonly keepsPlaces?: boolean;
}

/** The comparison's worker: features in, and all that is known of the set out. */
export interface Comparer {
  /** Tells or, with null, takes away the feature of a clip. */
  setFeature(clip: ClipId, name: string, feature: ClipFeature | null): void;
  /** Compares the clips told so far; a newer call cancels an older one. All below speak of the latest. */
  compare(settings: ComparisonSettings, options?: CompareOptions): Promise<Comparison>;
  /** The clips told since, each with its place on the map, on which nothing moves for them. */
  arrivals(): Promise<MapPlaces>;
  cut(clusters: number): Promise<Cut>;
  picture(region: MatrixRegion, work?: WorkOptions): Promise<MatrixPicture>;
  explain(a: ClipId, b: ClipId, work?: WorkOptions): Promise<Explanation>;
  /** The nearest first; of equals the earlier. */
  neighbours(clip: ClipId, most: number): Promise<readonly Neighbour[]>;
  evaluate(labelled: LabelledCut, work?: WorkOptions): Promise<Evaluation>;
  /** Warps clip b onto clip a; both are read again if need be. */
  warp(a: ClipId, b: ClipId, settings: WarpSettings, work?: WorkOptions): Promise<Warping>;
  exportFile(kind: ComparisonExportKind, labelled: LabelledCut, work?: WorkOptions): Promise<Blob>;
  destroy(): void;
}
