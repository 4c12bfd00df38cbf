/**
 * The state of comparing: settings and selection are written by actions, what the comparison found
 * is written by the following of it (`comparing.ts`), views read all of it.
 */
import { signal, type Signal } from '@preact/signals-core';
import type {
  Comparison,
  ComparisonSettings,
  Cut,
  Evaluation,
  Explanation,
  Neighbour,
} from '../engine/comparison-types';
import type { ClipId } from '../engine/types';
import type { LabelRenames } from './labels';

export type Page = 'study' | 'compare' | 'pair';

/** Where labels come from; those given by hand come before. */
export type LabelRule =
  | { readonly kind: 'none' }
  | { readonly kind: 'folder' }
  | { readonly kind: 'pattern'; readonly pattern: string };

export type MatrixOrder = 'tree' | 'label' | 'name';

export type CompareTab = 'why' | 'neighbours' | 'table';

/** How the clips of the pair page run together. */
export type Synchronisation = 'start' | 'keypose' | 'warp';

export interface ClipPair {
  readonly a: ClipId;
  readonly b: ClipId;
}

/** In the plane of the map. */
export type MapPlace = readonly [number, number];

export interface CompareStore {
  readonly page: Signal<Page>;
  readonly settings: Signal<ComparisonSettings>;
  /** The latest comparison; it stays, dimmed, while a newer one is made. */
  readonly comparison: Signal<Comparison | null>;
  /** Where clips have arrived on the map that the latest comparison does not cover, or lately did not. */
  readonly arrivals: Signal<ReadonlyMap<ClipId, MapPlace>>;
  /** 0 to 1 while comparing, else null. */
  readonly comparing: Signal<number | null>;
  /** What the person set the cut to; null: automatic. */
  readonly cutClusters: Signal<number | null>;
  readonly cut: Signal<Cut | null>;
  readonly labelRule: Signal<LabelRule>;
  /** Labels by hand; '' takes a label away. */
  readonly handLabels: Signal<ReadonlyMap<ClipId, string>>;
  /** What labels from the rule are called instead. */
  readonly labelRenames: Signal<LabelRenames>;
  readonly evaluation: Signal<Evaluation | null>;
  readonly order: Signal<MatrixOrder>;
  /** The second clip of the selection; the first is the open clip. */
  readonly otherId: Signal<ClipId | null>;
  /** More clips on the pair page, besides the selection. */
  readonly alsoIds: Signal<readonly ClipId[]>;
  readonly hovered: Signal<ClipPair | null>;
  readonly explanation: Signal<Explanation | null>;
  readonly neighbours: Signal<readonly Neighbour[]>;
  readonly tab: Signal<CompareTab>;
  readonly synchronisation: Signal<Synchronisation>;
  readonly superposed: Signal<boolean>;
  readonly mirrorB: Signal<boolean>;
}

export const usualSettings: ComparisonSettings = {
  distance: { measure: 'posture-variation', mirrorAware: false, acrossRigs: false },
  linkage: 'ward',
};

export function createCompareStore(): CompareStore {
  return {
    page: signal<Page>('study'),
    settings: signal(usualSettings),
    comparison: signal<Comparison | null>(null),
    arrivals: signal<ReadonlyMap<ClipId, MapPlace>>(new Map()),
    comparing: signal<number | null>(null),
    cutClusters: signal<number | null>(null),
    cut: signal<Cut | null>(null),
    labelRule: signal<LabelRule>({ kind: 'none' }),
    handLabels: signal<ReadonlyMap<ClipId, string>>(new Map()),
    labelRenames: signal<LabelRenames>(new Map()),
    evaluation: signal<Evaluation | null>(null),
    order: signal<MatrixOrder>('tree'),
    otherId: signal<ClipId | null>(null),
    alsoIds: signal<readonly ClipId[]>([]),
    hovered: signal<ClipPair | null>(null),
    explanation: signal<Explanation | null>(null),
    neighbours: signal<readonly Neighbour[]>([]),
    tab: signal<CompareTab>('why'),
    synchronisation: signal<Synchronisation>('warp'),
    superposed: signal(false),
    mirrorB: signal(false),
  };
}
